// SPDX-License-Identifier: Apache-2.0
// Two records of runs (run.json).
#pragma once

#include "xgm/base/json.hpp"
#include "xgm/evaluation/run_diff.hpp"

namespace xgm {

/// Fills configuration, program, inputs and figures. What neither record has is no difference.
void compare_records(const Json& first, const Json& second, RunDiff& diff);

}  // namespace xgm
