// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/camera/read_rpc.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "camera/rpc_fields.hpp"
#include "camera/rpc_formats.hpp"
#include "ground/gdal.hpp"
#include "ground/paths.hpp"
#include "xgm/base/error.hpp"

namespace xgm::geo {
namespace {

bool ends_with_one_of(const std::string& file, std::initializer_list<std::string_view> endings) {
  std::string name = std::filesystem::path(file).filename().string();
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::any_of(endings, [&](std::string_view e) { return name.ends_with(e); });
}

}  // namespace

std::vector<RpcModel> read_rpc_of_image(const std::string& file) {
  const DatasetPtr dataset = open_raster(file);
  char** const metadata = dataset->GetMetadata("RPC");
  if (metadata == nullptr) return {};
  RpcFields fields(file);
  for (char** entry = metadata; *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    const std::size_t equals = text.find('=');
    if (equals != std::string_view::npos)
      fields.add(text.substr(0, equals), text.substr(equals + 1));
  }
  return {fields.model()};  // GDAL has turned vendors' first pixels into (0, 0)
}

std::vector<RpcModel> read_rpc(const std::string& file) {
  if (!is_there(file)) throw Error(file + ": there is no such file");
  if (ends_with_one_of(file, {".xml"})) return read_xml_rpc(file);
  if (ends_with_one_of(file, {".txt", ".rpb", ".geom", ".yaml", ".yml", ".json", ".rpc"})) {
    return read_text_rpc(file);
  }
  std::vector<RpcModel> models = read_rpc_of_image(file);
  if (models.empty()) {
    throw Error(file +
                ": holds no RPC model; give the vendor's file (_RPC.TXT, .RPB, RPC_*.XML) "
                "beside the image");
  }
  return models;
}

}  // namespace xgm::geo
