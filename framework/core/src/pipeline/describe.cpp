// SPDX-License-Identifier: Apache-2.0
// A plugin explained to its users, from its one declaration.
#include "xgm/pipeline/describe.hpp"
#include "config/fields.hpp"
#include "xgm/base/json.hpp"

namespace xgm {
namespace {

// As one would write it in a pipeline: names without quotes.
std::string yaml_text(const Json& value) {
  if (!value.is_string()) return value.dump();
  return value.text().empty() ? "none" : value.text();
}

std::string default_text(const Field& field) {
  if (is_stage_list(field)) return "none";
  if (!is_stage(field)) return yaml_text(value_of(field));
  if (!field.default_stage_name.empty()) return field.default_stage_name;
  return field.is_optional ? "none" : "required";
}

// What may stand there, with the unit: "a whole number from 0 to 3000, px".
std::string type_text(const Field& field) {
  return expected(field) + (field.unit_name.empty() ? "" : ", " + field.unit_name);
}

std::string rule_text(const Rule& rule) { return rule.fields.front() + " " + rule.message + "."; }

Json field_json(const Field& field) {
  Json json{{"name", field.name}, {"text", field.text}, {"expected", expected(field)}};
  if (!field.unit_name.empty()) json["unit"] = field.unit_name;
  if (field.minimum) json["range"] = {*field.minimum, *field.maximum};
  if (field.only_odd) json["odd"] = true;
  if (field.only_whole) json["whole"] = true;
  if (!field.counts.empty()) json["counts"] = field.counts;
  if (!field.choices.empty()) json["choices"] = field.choices;
  if (const auto* choice = std::get_if<Choice>(&field.target)) json["choices"] = choice->names;
  if (is_stage(field) || is_stage_list(field)) {
    json["kind"] = stage_kind(field);
    json["default"] = default_text(field);
  } else {
    json["default"] = value_of(field);
  }
  return json;
}

}  // namespace

std::string describe_text(const PluginInfo& plugin) {
  const auto prototype = plugin.prototype();
  const ParameterSet& set = prototype->parameters();
  std::string text = plugin.name + " (" + plugin.kind + ")\n  " + plugin.summary + "\n";
  if (!plugin.publication.empty()) text += "  Source: " + plugin.publication + "\n";
  if (!plugin.origin.empty()) text += "  Loaded from: " + plugin.origin + "\n";
  text += set.fields().empty() ? "\nNo parameters.\n" : "\nParameters:\n";
  for (const Field& field : set.fields()) {
    text += "  " + field.name + " = " + default_text(field) + "\n      " + field.text + "\n      " +
            type_text(field) + "\n";
  }
  for (const Rule& rule : set.rules()) text += "  Rule: " + rule_text(rule) + "\n";
  return text;
}

std::string describe_json(const PluginInfo& plugin) {
  const auto prototype = plugin.prototype();
  const ParameterSet& set = prototype->parameters();
  Json json{{"name", plugin.name},       {"kind", plugin.kind},
            {"summary", plugin.summary}, {"publication", plugin.publication},
            {"origin", plugin.origin},   {"parameters", Json::array()},
            {"rules", Json::array()}};
  for (const Field& field : set.fields()) json["parameters"].push_back(field_json(field));
  for (const Rule& rule : set.rules()) json["rules"].push_back(rule_text(rule));
  return json.dump(2);
}

std::string describe_markdown(const PluginInfo& plugin) {
  const auto prototype = plugin.prototype();
  const ParameterSet& set = prototype->parameters();
  std::string text = "## " + plugin.name + "\n\n" + plugin.summary + "\n\n";
  if (!plugin.publication.empty()) text += "Source: " + plugin.publication + "\n\n";
  if (set.fields().empty()) return text + "No parameters.\n\n";
  text += "| parameter | default | value | meaning |\n|---|---|---|---|\n";
  for (const Field& field : set.fields()) {
    text += "| `" + field.name + "` | `" + default_text(field) + "` | " + type_text(field) + " | " +
            field.text + " |\n";
  }
  text += "\n";
  for (const Rule& rule : set.rules())
    text += "Rule: `" + rule.fields.front() + "` " + rule.message + ".\n\n";
  return text;
}

}  // namespace xgm
