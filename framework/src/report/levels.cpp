// SPDX-License-Identifier: Apache-2.0
// Picks the levels of a pyramid out of what the stages of a run produce.
#include <algorithm>
#include <regex>

#include "xgm/report.hpp"

namespace xgm {

void LevelCollector::stage_end(const std::string& stage_path, const StageStatistics&,
                               const Artifact& result) {
  static const std::regex at_level(R"(((?:.*\.)?s(\d+))\.(?:matcher|search_range))");
  std::smatch match;
  if (!std::regex_match(stage_path, match, at_level)) return;
  if (stage_path.find("reverse.") != std::string::npos) return;
  const auto at = [&]() -> ReportLevel& { return level(match[1], std::stoi(match[2])); };
  if (const auto* const* matched = std::get_if<const MatchResult*>(&result)) {
    at().map = (*matched)->forward.clone();
  } else if (const auto* const* range = std::get_if<const DisparityRange*>(&result)) {
    at().range = **range;
  }
}

std::vector<ReportLevel> LevelCollector::levels() const {
  std::vector<ReportLevel> finished;
  std::copy_if(levels_.begin(), levels_.end(), std::back_inserter(finished),
               [](const ReportLevel& level) { return !level.map.disparity.empty(); });
  std::stable_sort(finished.begin(), finished.end(),
                   [](const ReportLevel& a, const ReportLevel& b) { return a.scale > b.scale; });
  return finished;
}

ReportLevel& LevelCollector::level(const std::string& stage_path, int scale) {
  const auto known = std::find_if(levels_.begin(), levels_.end(), [&](const ReportLevel& level) {
    return level.stage_path == stage_path;
  });
  if (known != levels_.end()) return *known;
  ReportLevel fresh;
  fresh.stage_path = stage_path;
  fresh.scale = scale;
  return levels_.emplace_back(std::move(fresh));
}

}  // namespace xgm
