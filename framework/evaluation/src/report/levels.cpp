// SPDX-License-Identifier: Apache-2.0
// Picks the levels of a pyramid out of what the stages of a run produce.
#include <algorithm>
#include <regex>

#include "xgm/evaluation/report.hpp"

namespace xgm {

void LevelCollector::stage_input(const std::string& stage_path, const Artifact& input) {
  if (const auto* const* request = std::get_if<const MatchRequest*>(&input)) {
    if (ReportLevel* level = level_at(stage_path)) level->range = (*request)->range;
  }
}

void LevelCollector::stage_end(const std::string& stage_path, const StageStatistics&,
                               const Artifact& result) {
  if (const auto* const* matched = std::get_if<const MatchResult*>(&result)) {
    if (ReportLevel* level = level_at(stage_path)) level->map = (*matched)->forward.clone();
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

ReportLevel* LevelCollector::level_at(const std::string& matcher_path) {
  static const std::regex at_level(R"(((?:.*\.)?s(\d+))\.matcher)");
  std::smatch match;
  if (!std::regex_match(matcher_path, match, at_level)) return nullptr;
  if (matcher_path.find("reverse.") != std::string::npos) return nullptr;
  const std::string stage_path = match[1];
  const auto known = std::find_if(levels_.begin(), levels_.end(), [&](const ReportLevel& level) {
    return level.stage_path == stage_path;
  });
  if (known != levels_.end()) return &*known;
  ReportLevel fresh;
  fresh.stage_path = stage_path;
  fresh.scale = std::stoi(match[2]);
  return &levels_.emplace_back(std::move(fresh));
}

}  // namespace xgm
