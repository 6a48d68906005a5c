// SPDX-License-Identifier: Apache-2.0
// What a run leaves behind: files in the output folder and a summary on stdout.
#pragma once

#include <string>
#include <vector>

#include "xgm/data/disparity_map.hpp"
#include "xgm/evaluation/explain.hpp"
#include "xgm/evaluation/report.hpp"
#include "xgm/evaluation/run_record.hpp"

namespace xgm::cli {

/// Writes disparity.pfm, disparity.png, status.png and run.json. Throws Error.
void write_results(const std::string& folder, const DisparityMap& map, const RunRecord& record);

/// Writes report.html; the run's name and record are filled in. Throws Error.
void write_report(const std::string& folder, const RunRecord& record, const Image& left,
                  const GroundTruth& truth, ReportRun run);

/// Writes explain.json. Throws Error.
void write_explanations(const std::string& folder, const std::string& explanations);

void print_summary(const std::string& folder, const RunRecord& record, bool has_report);

/// Warns of a map with few disparities, or with many at an end of the search range; the exit code:
/// failed if there is none at all.
int judge(const DisparityMap& map, const RunRecord& record);

}  // namespace xgm::cli
