// SPDX-License-Identifier: Apache-2.0
#include "pipeline/graph.hpp"

namespace xgm {
namespace {

bool is_stage_value(const Json& value) { return value.is_object(); }
bool is_stage_list_value(const Json& value) {
  return value.is_array() && !value.empty() && value.elements().front().is_object();
}

std::string text_of(const Json& value) { return value.is_string() ? value.text() : value.dump(); }

// One stage: its name and plain parameters in one line, the stages inside below it.
void write(const Json& stage, const std::string& label, const std::string& indent,
           std::string& text) {
  text += indent + label;
  if (const Json* type = stage.find("type")) text += ": " + type->text();
  std::string values;
  for (const auto& [key, value] : stage.members()) {
    const bool plain = key != "type" && !value.is_null() && !is_stage_value(value) &&
                       !is_stage_list_value(value) && !(value.is_array() && value.empty());
    if (plain) values += (values.empty() ? "" : ", ") + key + "=" + text_of(value);
  }
  text += values.empty() ? "\n" : "  (" + values + ")\n";
  for (const auto& [key, value] : stage.members()) {
    if (is_stage_value(value)) write(value, key, indent + "  ", text);
    if (!is_stage_list_value(value)) continue;
    for (std::size_t i = 0; i < value.size(); ++i) {
      write(value.elements()[i], key + "[" + std::to_string(i) + "]", indent + "  ", text);
    }
  }
}

}  // namespace

std::string graph_text(const Json& resolved) {
  std::string text;
  write(resolved, "pipeline", "", text);
  return text;
}

}  // namespace xgm
