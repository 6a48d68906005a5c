// SPDX-License-Identifier: Apache-2.0
#include "record/inputs_json.hpp"

#include "xgm/evaluation/run_record.hpp"

namespace xgm {

nlohmann::ordered_json to_json(const std::vector<InputFile>& inputs) {
  auto list = nlohmann::ordered_json::array();
  for (const InputFile& input : inputs) {
    list.push_back({{"role", input.role},
                    {"file", input.file},
                    {"bytes", input.identity.bytes},
                    {"fnv1a64", input.identity.fnv1a64}});
  }
  return list;
}

std::vector<InputFile> recorded_inputs(const std::string& run_json) {
  std::vector<InputFile> inputs;
  try {
    const auto record = nlohmann::json::parse(run_json);
    for (const auto& input : record.at("scene").at("inputs")) {
      inputs.push_back({input.at("role"),
                        input.at("file"),
                        {.bytes = input.at("bytes"), .fnv1a64 = input.at("fnv1a64")}});
    }
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  return inputs;
}

}  // namespace xgm
