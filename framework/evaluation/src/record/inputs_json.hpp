// SPDX-License-Identifier: Apache-2.0
// Which files were read, as JSON.
#pragma once

#include "xgm/base/json.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {

Json to_json(const std::vector<InputFile>& inputs);

}  // namespace xgm
