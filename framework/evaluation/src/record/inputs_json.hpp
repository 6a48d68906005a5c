// SPDX-License-Identifier: Apache-2.0
// Which files were read, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "xgm/io/scene.hpp"

namespace xgm {

nlohmann::ordered_json to_json(const std::vector<InputFile>& inputs);

}  // namespace xgm
