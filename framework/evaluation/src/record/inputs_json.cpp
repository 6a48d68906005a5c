// SPDX-License-Identifier: Apache-2.0
#include "record/inputs_json.hpp"

#include "xgm/base/error.hpp"
#include "xgm/evaluation/run_record.hpp"

namespace xgm {

Json to_json(const std::vector<InputFile>& inputs) {
  Json list = Json::array();
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
    const Json record = Json::parse(run_json);
    for (const Json& input : record.at("scene").at("inputs")) {
      inputs.push_back({input.at("role").text(),
                        input.at("file").text(),
                        {.bytes = static_cast<std::uintmax_t>(input.at("bytes").number()),
                         .fnv1a64 = input.at("fnv1a64").text()}});
    }
  } catch (const Error&) {
    return {};
  }
  return inputs;
}

}  // namespace xgm
