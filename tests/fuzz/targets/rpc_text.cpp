// SPDX-License-Identifier: Apache-2.0
// RPC cameras in texts. The first byte tells the file's ending: 't' _RPC.TXT, 'b' .RPB, 'g' .geom,
// 'y' .yaml, 'j' .json; the rest is the file.
#include "fuzz/support/rpc_texts.hpp"
#include "fuzz/support/target.hpp"
#include "support/sample_camera.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/camera/read_rpc.hpp"

namespace xgm::fuzz {
namespace {

std::string name_for(char kind) {
  switch (kind) {
    case 'b':
      return "camera.RPB";
    case 'g':
      return "camera.geom";
    case 'y':
      return "camera.yaml";
    case 'j':
      return "camera.json";
    default:
      return "camera_RPC.TXT";
  }
}

/// {"row_offset": 1, ..., "row_num": [1, 2, ...]}: what rpcm writes; it is YAML, too.
std::string dictionary() {
  const geo::RpcModel model = testing::sample_camera();
  std::string text = "{";
  const auto axis = [&](const std::string& name, const geo::RpcAxis& a) {
    text += "\"" + name + "_offset\": " + std::to_string(a.offset) + ", \"" + name +
            "_scale\": " + std::to_string(a.scale) + ", ";
  };
  const auto list = [&](const std::string& name, const geo::RpcPolynomial& polynomial) {
    std::string items;
    for (const double value : polynomial)
      items += (items.empty() ? "" : ", ") + std::to_string(value);
    text += "\"" + name + "\": [" + items + "], ";
  };
  axis("row", model.row);
  axis("col", model.column);
  axis("lat", model.latitude);
  axis("lon", model.longitude);
  axis("alt", model.height);
  list("row_num", model.row_ratio.numerator);
  list("row_den", model.row_ratio.denominator);
  list("col_num", model.column_ratio.numerator);
  list("col_den", model.column_ratio.denominator);
  return text + "\"satellite\": \"none\"}";
}

/// "lineNumCoef = (1, 2, ...);"
std::string rpb() {
  std::string text = "BEGIN_GROUP = IMAGE\n";
  for (const char* axis : {"line", "samp", "lat", "long", "height"}) {
    text += "\t" + std::string(axis) + "Offset = 12.5;\n\t" + axis + "Scale = 1.5;\n";
  }
  for (const char* list : {"lineNumCoef", "lineDenCoef", "sampNumCoef", "sampDenCoef"}) {
    text += "\t" + std::string(list) + " = (\n";
    for (int i = 1; i <= 20; ++i)
      text += "\t\t\t1.0E-0" + std::to_string(i % 10) + (i < 20 ? ",\n" : ");\n");
  }
  return text + "END_GROUP = IMAGE\nEND;\n";
}

}  // namespace

void check(std::string_view input) {
  static const testing::TemporaryFolder folder;
  if (input.empty()) return;
  const std::string name = name_for(input.front());
  const std::string file = folder.write(name, std::string(input.substr(1)));
  std::vector<geo::RpcModel> models;
  if (accepts(name, [&] { models = geo::read_rpc(file); })) check_cameras(models);
}

std::vector<std::string> seeds() {
  return {"t" + sample_text(), "g" + sample_text(), "b" + rpb(),
          "j" + dictionary(),  "y" + dictionary(),  "yrpc: &a\n  rpc: *a\n"};
}

std::vector<std::string> words() {
  std::vector<std::string> words = rpc_words();
  for (const char* word : {"row_num", "col_offset", "alt_scale", "[", "]", "{", "}", "&a ", "*a",
                           "\n  ", "\n- ", "<<: ", "!!float ", "\"", "BEGIN_GROUP = ", "END;"}) {
    words.emplace_back(word);
  }
  return words;
}

}  // namespace xgm::fuzz
