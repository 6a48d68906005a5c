// SPDX-License-Identifier: Apache-2.0
// The text of a pipeline file.
#include "fuzz/support/pipelines.hpp"
#include "fuzz/support/target.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::fuzz {

void check(std::string_view input) {
  check_loaded(load_pipeline_text(std::string(input), "fuzzed.yaml", builtins()), {"fuzzed.yaml"});
}

std::vector<std::string> seeds() {
  std::vector<std::string> texts;
  for (const std::string& name : shipped_pipelines()) {
    texts.push_back(shipped_text(name));
    texts.push_back(require_pipeline(name, builtins()).resolved_json());
  }
  return texts;
}

std::vector<std::string> words() { return yaml_words(); }

}  // namespace xgm::fuzz
