// SPDX-License-Identifier: Apache-2.0
// What the files of a finished run amount to.
#pragma once

#include <string>

#include "xgm/evaluation/bench.hpp"

namespace xgm {

/// Figures of the run that left its files in `folder`, judged by the scene's truth as it is now.
/// Throws Error or another exception if a file cannot be read.
BenchCell judge_cell(const std::string& folder, const BenchScene& scene, const BenchRules& rules);

/// The map of a run; pixels have a disparity or are "ambiguous".
DisparityMap read_result(const std::string& folder);
/// Gives the pixels the statuses that the run's status.png shows, as far as it can be read.
void read_statuses(const std::string& folder, DisparityMap& map);

}  // namespace xgm
