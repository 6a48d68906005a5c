// SPDX-License-Identifier: Apache-2.0
// What the files of a finished run amount to.
#pragma once

#include <string>

#include "xgm/bench.hpp"

namespace xgm {

/// Figures of the run that left its files in `folder`, judged by the scene's truth as it is now.
/// Throws Error or another exception if a file cannot be read.
BenchCell judge_cell(const std::string& folder, const BenchScene& scene, const BenchRules& rules);

/// The map of a run; all that is not finite counts as without disparity.
DisparityMap read_result(const std::string& folder);

}  // namespace xgm
