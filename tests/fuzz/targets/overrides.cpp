// SPDX-License-Identifier: Apache-2.0
// Values of --set: each line is PATH=VALUE, all of them for one shipped pipeline.
#include "fuzz/support/pipelines.hpp"
#include "fuzz/support/target.hpp"

namespace xgm::fuzz {
namespace {

Override to_override(std::string_view line) {
  const std::size_t equals = std::min(line.find('='), line.size());
  const std::size_t value = std::min(equals + 1, line.size());
  return {std::string(line.substr(0, equals)), std::string(line.substr(value))};
}

}  // namespace

void check(std::string_view input) {
  static const std::string text = shipped_text("tmgm16_refined.yaml");
  std::vector<Override> overrides;
  for (std::size_t begin = 0; begin < input.size();) {
    const std::size_t end = std::min(input.find('\n', begin), input.size());
    overrides.push_back(to_override(input.substr(begin, end - begin)));
    begin = end + 1;
  }
  check_loaded(load_pipeline_text(text, "shipped.yaml", builtins(), overrides),
               {"shipped.yaml", "--set "});
}

std::vector<std::string> seeds() {
  return {"matcher.scale=4", "postprocess=[]\npostprocess=[{type: median, window: 3}]",
          "matcher.matcher.matcher.filters[0]=median",
          "matcher.search_range.window=31\nmatcher.matcher.matcher.cost={type: census, window: 7}",
          "matcher={type: opencv_sgbm}\ndisparities=[0, 63]"};
}

std::vector<std::string> words() {
  std::vector<std::string> all = yaml_words();
  for (const char* word : {"matcher.", "[0]", "[18446744073709551615]", "\n", "="}) {
    all.emplace_back(word);
  }
  return all;
}

}  // namespace xgm::fuzz
