// SPDX-License-Identifier: Apache-2.0
#include "pipelines/from_schema.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace xgm::testing {
namespace {

using Json = nlohmann::json;

/// Kind of the stages that a reference stands for; empty if it is none.
std::string kind_of(const Json& schema) {
  if (!schema.contains("$ref")) return "";
  const std::string reference = schema.at("$ref");
  return reference.substr(reference.rfind('/') + 1);
}

/// Matchers in matchers take time, and say no more the deeper they are.
bool holds_matcher(const Json& plugin) {
  const Json& properties = plugin.at("properties");
  return properties.contains("matchers") ||
         (properties.contains("matcher") && kind_of(properties.at("matcher")) == "matcher");
}

}  // namespace

PipelineGenerator::PipelineGenerator(const std::string& schema, std::uint64_t seed)
    : schema_(Json::parse(schema)), family_(schema_), random_(seed) {
  if (!schema_.contains("anyOf")) return;  // there is no other family
  for (const Json& family : schema_.at("anyOf")) {
    if (family.at("properties").at("type").at("const") == "stereo") family_ = family;
  }
}

std::string PipelineGenerator::next() { return fields_of(family_, 0).dump(); }

Json PipelineGenerator::fields_of(const Json& schema, int depth) {
  Json fields = Json::object();
  const Json required = schema.value("required", Json::array());  // absent if nothing is
  for (const auto& [name, field] : schema.at("properties").items()) {
    const bool needed = std::find(required.begin(), required.end(), name) != required.end();
    if (field.contains("const")) {
      if (needed) fields[name] = field.at("const");
    } else if (needed || !chance(3)) {
      fields[name] = value_of(field, depth);
    }
  }
  return fields;
}

Json PipelineGenerator::value_of(const Json& field, int depth) {
  if (const std::string kind = kind_of(field); !kind.empty()) return stage_of(kind, depth);
  if (field.contains("anyOf") && !field.contains("items")) {  // a stage, or null
    return chance(4) ? Json() : value_of(field.at("anyOf")[0], depth);
  }
  if (field.contains("items")) return list_of(field, depth);
  if (field.contains("default") && chance(3)) return field.at("default");
  if (field.contains("enum")) {
    const Json& choices = field.at("enum");
    const auto chosen =
        static_cast<std::size_t>(random_.integer(0, static_cast<int>(choices.size()) - 1));
    const Json& value = choices[chosen];
    return field.value("type", "") == "integer" ? Json(value.get<int>()) : value;
  }
  if (field.at("type") == "boolean") return chance(2);
  if (!field.contains("minimum")) return "";  // the name of a file
  return number_of(field);
}

Json PipelineGenerator::stage_of(const std::string& kind, int depth) {
  std::vector<const Json*> plugins;
  for (const Json& plugin : schema_.at("definitions").at(kind).at("anyOf")) {
    constexpr int kDeepest = 2;
    if (!plugin.contains("properties") || (depth >= kDeepest && holds_matcher(plugin))) continue;
    plugins.push_back(&plugin);
  }
  const auto chosen =
      static_cast<std::size_t>(random_.integer(0, static_cast<int>(plugins.size()) - 1));
  return fields_of(*plugins[chosen], depth + 1);
}

Json PipelineGenerator::number_of(const Json& field) {
  const double low = field.at("minimum"), high = field.at("maximum");
  double value = chance(3) ? low : chance(2) ? high : random_.real(low, high);
  if (field.at("type") == "number") return value;
  const bool odd = field.contains("not");
  value = std::floor(value);
  if (odd && std::fmod(value, 2) == 0) value += value < high ? 1 : -1;
  return static_cast<std::int64_t>(value);
}

Json PipelineGenerator::list_of(const Json& field, int depth) {
  Json list = Json::array();
  const int most = field.contains("anyOf") ? 0 : 2;  // lists of a fixed length may be empty
  for (int i = random_.integer(0, most); i > 0; --i)
    list.push_back(value_of(field.at("items"), depth));
  return list;
}

}  // namespace xgm::testing
