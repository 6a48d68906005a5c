// SPDX-License-Identifier: Apache-2.0
// Any JSON, and the files that a run.json names: what is read, written and read again is the same.
#include <algorithm>
#include <filesystem>

#include "fuzz/support/target.hpp"
#include "xgm/base/json.hpp"
#include "xgm/evaluation/run_record.hpp"

namespace xgm::fuzz {
namespace {

bool same_input(const InputFile& a, const InputFile& b) {
  return a.role == b.role && a.file == b.file && a.identity.bytes == b.identity.bytes &&
         a.identity.fnv1a64 == b.identity.fnv1a64;
}

bool same_output(const OutputFile& a, const OutputFile& b) {
  return a.file == b.file && a.bytes == b.bytes;
}

RunRecord record_of(std::vector<InputFile> inputs, std::vector<OutputFile> outputs) {
  RunRecord record;
  record.resolved_pipeline = "{}";
  record.inputs = std::move(inputs);
  record.outputs = std::move(outputs);
  return record;
}

/// The next run in the folder removes what this one wrote: nothing else may be named.
void check_outputs(const std::vector<OutputFile>& outputs) {
  for (const OutputFile& output : outputs) {
    const std::filesystem::path file = std::filesystem::path("folder") / output.file;
    const std::string inside = file.lexically_normal().generic_string();
    require(inside.starts_with("folder/") && inside != "folder/", "an output is in its folder");
  }
}

}  // namespace

void check(std::string_view input) {
  Json json;
  const bool is_json = accepts("", [&] { json = Json::parse(input); });
  const std::vector<InputFile> inputs = recorded_inputs(std::string(input));
  const std::vector<OutputFile> outputs = recorded_outputs(std::string(input));
  if (!is_json) {
    require(inputs.empty() && outputs.empty(), "what is no JSON names no files");
    return;
  }
  check_outputs(outputs);
  const std::string printed = json.dump(2);
  require(Json::parse(printed).dump(2) == printed, "JSON that is printed is read as it was");
  const std::string record = to_json(record_of(inputs, outputs));
  require(std::ranges::equal(recorded_inputs(record), inputs, same_input),
          "inputs that are recorded are read as they were");
  require(std::ranges::equal(recorded_outputs(record), outputs, same_output),
          "outputs that are recorded are read as they were");
}

std::vector<std::string> seeds() {
  return {to_json(record_of({{"left", "im0.png", {123, "0123456789abcdef"}}},
                            {{"disparity.pfm", 12}, {"dump/cost.npy", {}}})),
          R"({"scene": {"inputs": [{"role": "r", "file": "f", "bytes": 1, "fnv1a64": "0"}]}})",
          R"([null, true, -1, 2.5e-3, 18446744073709551615, "\u00e4\n", {"a": {}}, []])"};
}

std::vector<std::string> words() {
  return {"{\"scene\":{\"inputs\":[",
          "\"role\":",
          "\"file\":",
          "\"bytes\":",
          "\"outputs\":[",
          "../",
          "\"fnv1a64\":",
          "-1",
          "1e308",
          "1e400",
          "\\ud83d\\ude00",
          "\\u0000",
          "[[[[[[[[",
          "null"};
}

}  // namespace xgm::fuzz
