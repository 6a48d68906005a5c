// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <functional>
#include <string_view>

#include "camera/rpc_fields.hpp"
#include "camera/rpc_formats.hpp"
#include "ground/xml.hpp"
#include "xgm/base/error.hpp"

namespace xgm::geo {
namespace {

/// The first element of that name below `node`, at any depth; null if there is none.
const CPLXMLNode* find(const CPLXMLNode* node, std::string_view name) {
  for (const CPLXMLNode* child = node->psChild; child != nullptr; child = child->psNext) {
    if (is_element(child, name)) return child;
    if (const CPLXMLNode* below = find(child, name)) return below;
  }
  return nullptr;
}

/// Adds every element below `node` that has a text.
void add_values(const CPLXMLNode* node, RpcFields& fields) {
  for (const CPLXMLNode* child = node->psChild; child != nullptr; child = child->psNext) {
    if (child->eType != CXT_Element) continue;
    const char* const text = CPLGetXMLValue(child, nullptr, nullptr);
    if (text != nullptr && *text != '\0') fields.add(child->pszValue, text);
    add_values(child, fields);
  }
}

RpcModel dimap(const std::string& file, const CPLXMLNode& rfm) {
  RpcFields fields(file);
  const CPLXMLNode* const validity = find(&rfm, "RFM_Validity");
  if (validity == nullptr) throw Error(file + ": its RPC model has no RFM_Validity");
  add_values(validity, fields);
  // The block from the ground to the image. Before version 3 it is the inverse model, and the first
  // pixel is (1, 1); since then it is named for what it does, and the first pixel is (0.5, 0.5).
  if (const CPLXMLNode* const values = find(&rfm, "GroundtoImage_Values")) {
    add_values(values, fields);
    return fields.model(0.5);
  }
  const CPLXMLNode* const inverse = find(&rfm, "Inverse_Model");
  if (inverse == nullptr) throw Error(file + ": its RPC model has no Inverse_Model");
  add_values(inverse, fields);
  return fields.model(1);
}

/// DIMAP 1 has scales and offsets as A and B, and each ratio as one list of 40.
RpcModel dimap1(const std::string& file, const CPLXMLNode& sensor) {
  RpcFields fields(file);
  constexpr std::array<const char*, 5> kAxes{"Lon", "Lat", "Alt", "Col", "Row"};
  for (const char* axis : kAxes) {
    if (const CPLXMLNode* const node = find(&sensor, axis)) {
      fields.add(std::string(axis) + "_SCALE", CPLGetXMLValue(node, "A", ""));
      fields.add(std::string(axis) + "_OFF", CPLGetXMLValue(node, "B", ""));
    }
  }
  for (const char* axis : {"COL", "ROW"}) {
    const CPLXMLNode* const node = find(&sensor, "Inverse_Model");
    const std::string text =
        node != nullptr ? CPLGetXMLValue(node, (std::string("F_") + axis).c_str(), "") : "";
    std::size_t split = 0;
    for (int i = 0; i < 20 && split != std::string::npos; ++i) {
      split = text.find_first_of(" \n\t", text.find_first_not_of(" \n\t", split));
    }
    fields.add(std::string(axis) + "_NUM", std::string_view(text).substr(0, split));
    if (split != std::string::npos) {
      fields.add(std::string(axis) + "_DEN", std::string_view(text).substr(split));
    }
  }
  return fields.model(1);
}

/// One model per band.
std::vector<RpcModel> enmap(const std::string& file, const CPLXMLNode& rpcs) {
  std::vector<RpcModel> models;
  for (const CPLXMLNode* band = rpcs.psChild; band != nullptr; band = band->psNext) {
    if (band->eType != CXT_Element || find(band, "ROW_OFF") == nullptr) continue;
    RpcFields fields(file);
    add_values(band, fields);
    models.push_back(fields.model());
  }
  if (models.empty()) throw Error(file + ": its RPC block holds no model of a band");
  return models;
}

const CPLXMLNode& root_of(const CPLXMLNode* node) {
  while (node->psNext != nullptr && (node->eType != CXT_Element || node->pszValue[0] == '?')) {
    node = node->psNext;
  }
  return *node;
}

}  // namespace

std::vector<RpcModel> read_xml_rpc(const std::string& file) {
  const XmlPtr document = parse_xml_file(file);
  const CPLXMLNode& root = root_of(document.get());
  const std::string_view name = root.pszValue;
  if (name == "Dimap_Document" || name == "PHR_Dimap_Document") {
    const CPLXMLNode* const model = find(&root, "Global_RFM");
    if (model == nullptr) {
      throw Error(file + ": this DIMAP file holds no RPC model; give the RPC_*.XML that it names");
    }
    if (find(&root, "Rational_Sensor_Model") != nullptr) return {dimap1(file, *model)};
    return {dimap(file, *model)};
  }
  if (const CPLXMLNode* const block = name == "isd" ? find(&root, "RPB") : nullptr) {
    RpcFields fields(file);
    add_values(block, fields);
    return {fields.model()};
  }
  if (const CPLXMLNode* const rpcs = name == "level_X" ? find(&root, "RPC") : nullptr) {
    return enmap(file, *rpcs);
  }
  throw Error(file + ": XML of <" + std::string(name) +
              "> is none of the RPC formats; known are DIMAP (Dimap_Document), DigitalGlobe (isd "
              "with RPB) and EnMAP (level_X)");
}

}  // namespace xgm::geo
