// SPDX-License-Identifier: Apache-2.0
#include "record/inputs_json.hpp"

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

}  // namespace xgm
