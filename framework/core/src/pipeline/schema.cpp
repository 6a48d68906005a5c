// SPDX-License-Identifier: Apache-2.0
// JSON Schema of pipeline files: what the binder accepts, as far as a schema can say it (relations
// between parameters cannot be said).
#include <set>

#include "config/fields.hpp"
#include "xgm/base/json.hpp"
#include "xgm/pipeline/describe.hpp"
#include "xgm/stage/pipeline.hpp"

namespace xgm {
namespace {

Json reference(std::string_view kind) { return {{"$ref", "#/definitions/" + std::string(kind)}}; }

Json number(const Field& field, const char* type) {
  Json json{{"type", type}};
  if (field.minimum) {
    json["minimum"] = *field.minimum;
    json["maximum"] = *field.maximum;
  }
  if (field.only_odd) json["not"] = {{"multipleOf", 2}};
  if (field.choices.empty()) return json;
  for (const double choice : field.choices) json["enum"].push_back(choice);
  return json;
}

Json list(const Field& field) {
  Json json{{"type", "array"}, {"items", number(field, field.only_whole ? "integer" : "number")}};
  for (const std::size_t count : field.counts) {
    json["anyOf"].push_back({{"minItems", count}, {"maxItems", count}});
  }
  return json;
}

/// Whatever is written there is text, also what looks like a number.
Json text() { return {{"type", {"string", "number", "boolean"}}}; }

struct Describe {
  const Field& field;

  Json operator()(const bool*) const { return {{"type", "boolean"}}; }
  Json operator()(const int*) const { return number(field, "integer"); }
  Json operator()(const double*) const { return number(field, "number"); }
  Json operator()(const std::string*) const { return text(); }
  Json operator()(const std::vector<double>*) const { return list(field); }
  Json operator()(const std::vector<std::string>*) const {
    return {{"type", "array"}, {"items", text()}};
  }
  Json operator()(const Choice& choice) const { return {{"enum", choice.names}}; }
  Json operator()(const SlotBase* slot) const {
    if (!field.is_optional && field.default_stage_name.empty()) return reference(slot->kind());
    return {{"anyOf", {reference(slot->kind()), {{"type", "null"}}}}};
  }
  Json operator()(const SlotListBase* slots) const {
    return {{"type", {"array", "null"}}, {"items", reference(slots->kind())}};
  }
};

bool is_required(const Field& field) {
  return is_stage(field) && !field.is_optional && field.default_stage_name.empty();
}

Json object(const ParameterSet& set, Json properties, Json required) {
  for (const Field& field : set.fields()) {
    Json json = std::visit(Describe{field}, field.target);
    json["description"] =
        field.text + (field.unit_name.empty() ? "" : " [" + field.unit_name + "]");
    if (!is_stage(field) && !is_stage_list(field)) json["default"] = value_of(field);
    properties[field.name] = std::move(json);
    if (is_required(field)) required.push_back(field.name);
  }
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

// A stage is a bare name (if the plugin needs no nested stage) or a map with that type.
Json stage_schema(const std::string& kind, const Registry& registry) {
  std::vector<Json> names, maps;
  for (const PluginInfo* plugin : registry.plugins(kind)) {
    const auto prototype = plugin->prototype();
    Json map = object(prototype->parameters(), {{"type", {{"const", plugin->name}}}}, {"type"});
    if (map["required"].size() == 1) names.push_back(plugin->name);
    map["description"] = plugin->summary;
    maps.push_back(std::move(map));
  }
  if (maps.empty()) return {{"not", Json::object()}};
  const bool may_be_named = kind == PipelineFamily::kKind;  // by the name of its file
  if (may_be_named) return {{"anyOf", {Json{{"type", "string"}}, Json{{"anyOf", maps}}}}};
  if (!names.empty()) maps.insert(maps.begin(), Json{{"enum", names}});
  return {{"anyOf", maps}};
}

/// Kinds of all stages that may stand in a plugin's fields, at any depth.
void collect_kinds(const ParameterSet& set, const Registry& registry,
                   std::set<std::string>& kinds) {
  for (const Field& field : set.fields()) {
    if (!is_stage(field) && !is_stage_list(field)) continue;
    const std::string kind(stage_kind(field));
    if (!kinds.insert(kind).second) continue;
    for (const PluginInfo* plugin : registry.plugins(kind)) {
      collect_kinds(plugin->prototype()->parameters(), registry, kinds);
    }
  }
}

/// The top of a file. The family that is meant without 'type' need not be named.
Json family_schema(const PluginInfo& family, const Registry& registry,
                   std::set<std::string>& kinds) {
  const auto prototype = family.prototype();
  collect_kinds(prototype->parameters(), registry, kinds);
  int version = 1;
  ParameterSet format;
  format.add("xgm", version, "Version of the file format.").range(1, 1);
  Json properties = object(format, Json::object(), Json::array())["properties"];
  properties["type"] = {{"const", family.name}};
  Json required = Json::array();
  if (family.name != PipelineFamily::kDefault) required.push_back("type");
  return object(prototype->parameters(), std::move(properties), std::move(required));
}

}  // namespace

std::string pipeline_schema(const Registry& registry) {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "xgm pipeline"}};
  const auto families = registry.plugins(PipelineFamily::kKind);
  std::set<std::string> kinds;
  if (families.size() == 1) {
    schema.update(family_schema(*families.front(), registry, kinds));
  } else {
    schema["anyOf"] = Json::array();
    for (const PluginInfo* family : families) {
      schema["anyOf"].push_back(family_schema(*family, registry, kinds));
    }
  }
  Json definitions = Json::object();
  for (const KindInfo& kind : registry.kinds()) {
    if (kinds.contains(kind.name)) definitions[kind.name] = stage_schema(kind.name, registry);
  }
  schema["definitions"] = std::move(definitions);
  return schema.dump(2);
}

}  // namespace xgm
