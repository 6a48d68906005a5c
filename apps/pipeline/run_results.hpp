// SPDX-License-Identifier: Apache-2.0
// What a run leaves behind: files in the output folder and a summary on stdout.
#pragma once

#include <string>
#include <vector>

#include "xgm/data/disparity_map.hpp"
#include "xgm/explain.hpp"
#include "xgm/run_record.hpp"

namespace xgm::cli {

/// Writes disparity.pfm, disparity.png, status.png and run.json. Throws Error.
void write_results(const std::string& folder, const DisparityMap& map, const RunRecord& record);

/// Writes explain.json. Throws Error.
void write_explanations(const std::string& folder, const std::vector<Explanation>& explanations);

void print_summary(const std::string& folder, const RunRecord& record);

/// Warns of a map with few disparities, or with many at an end of the search range; the exit code:
/// failed if there is none at all.
int judge(const DisparityMap& map, const RunRecord& record);

}  // namespace xgm::cli
