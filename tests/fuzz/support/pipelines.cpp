// SPDX-License-Identifier: Apache-2.0
#include "fuzz/support/pipelines.hpp"

#include <algorithm>
#include <set>
#include <variant>

#include "fuzz/support/target.hpp"
#include "xgm/io/file.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::fuzz {
namespace {

bool begins_with_any(const std::string& text, const std::vector<std::string>& places) {
  return std::any_of(places.begin(), places.end(),
                     [&](const std::string& place) { return text.starts_with(place); });
}

void check_diagnostics(const Diagnostics& diagnostics, const std::vector<std::string>& places) {
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::string line = to_string(diagnostic);
    require(!diagnostic.message.empty(), "a diagnostic says what is wrong");
    require(line.find('\n') == std::string::npos, "a diagnostic is one line");
    require(begins_with_any(line, places), "a diagnostic begins with its place");
  }
}

void check_resolved(const Pipeline& pipeline) {
  const std::string resolved = pipeline.resolved_json();
  const LoadedPipeline again = load_pipeline_text(resolved, "resolved", builtins());
  require(again.pipeline.has_value(), "the resolved text of a pipeline is a pipeline");
  require(again.pipeline->resolved_json() == resolved, "what is resolved stays as it is");
  require(again.pipeline->graph() == pipeline.graph(), "both have the same graph");
  require(again.pipeline->disparities() == pipeline.disparities(), "both search the same");
  require(again.pipeline->accepts_range_maps() == pipeline.accepts_range_maps(),
          "both take range maps, or none does");
}

}  // namespace

void check_loaded(const LoadedPipeline& loaded, const std::vector<std::string>& places) {
  require(loaded.pipeline.has_value() == loaded.diagnostics.empty(),
          "there is either a pipeline or a diagnostic");
  check_diagnostics(loaded.diagnostics, places);
  if (loaded.pipeline) check_resolved(*loaded.pipeline);
}

std::string shipped_text(const std::string& name) { return read_file(find_pipeline(name)); }

std::vector<std::string> yaml_words() {
  std::set<std::string> found{"type: ", ": ",      ", ", "\n- ", "\n  ", "&a ",    "*a",
                              "<<: *a", "---\n",   "? ", "|\n",  ">-\n", "!!str ", "'",
                              "\"",     "\\u00e4", "#",  "~",    "null", "true",   ".inf",
                              ".nan",   "1e308",   "-1", "0x1f"};
  for (const PluginInfo* plugin : builtins().plugins()) {
    found.insert(plugin->name);
    const auto prototype = plugin->prototype();
    for (const Field& field : prototype->parameters().fields()) {
      found.insert(field.name + ": ");
      if (const auto* choice = std::get_if<Choice>(&field.target)) {
        found.insert(choice->names.begin(), choice->names.end());
      }
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace xgm::fuzz
