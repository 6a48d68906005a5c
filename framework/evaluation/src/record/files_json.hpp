// SPDX-License-Identifier: Apache-2.0
// Which files were read and written, as JSON.
#pragma once

#include "xgm/base/json.hpp"
#include "xgm/evaluation/run_record.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {

Json to_json(const std::vector<InputFile>& inputs);
Json to_json(const std::vector<OutputFile>& outputs);

}  // namespace xgm
