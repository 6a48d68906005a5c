// SPDX-License-Identifier: Apache-2.0
// Picks the levels of a pyramid out of what the stages of a run produce.
#include <algorithm>

#include "xgm/evaluation/report.hpp"

namespace xgm {

void LevelCollector::stage_input(const StagePlace& place, const Artifact& input) {
  if (const auto* const* request = std::get_if<const MatchRequest*>(&input)) {
    if (ReportLevel* level = level_of(place)) level->range = (*request)->range;
  }
}

void LevelCollector::stage_end(const StagePlace& place, const StageStatistics&,
                               const Artifact& result) {
  if (const auto* const* matched = std::get_if<const MatchResult*>(&result)) {
    if (ReportLevel* level = level_of(place)) {
      const DisparityMap& map = (*matched)->forward;  // its confidence is shown at full size alone
      level->map.disparity = map.disparity.clone();
      level->map.status = map.status.clone();
    }
  }
}

std::vector<ReportLevel> LevelCollector::levels() const {
  std::vector<ReportLevel> finished;
  std::copy_if(levels_.begin(), levels_.end(), std::back_inserter(finished),
               [](const ReportLevel& level) { return !level.map.disparity.empty(); });
  std::stable_sort(
      finished.begin(), finished.end(),
      [](const ReportLevel& a, const ReportLevel& b) { return a.level.scale > b.level.scale; });
  return finished;
}

/// The first matcher that is given a request in a level is the outermost one.
ReportLevel* LevelCollector::level_of(const StagePlace& matcher) {
  const Level& level = matcher.level;
  if (level.name.empty() || matcher.view != View::forward) return nullptr;
  const auto known = std::find_if(
      levels_.begin(), levels_.end(),
      [&](const ReportLevel& collected) { return collected.level.path == level.path; });
  if (known != levels_.end()) return known->matcher_path == matcher.path ? &*known : nullptr;
  ReportLevel fresh;
  fresh.level = level;
  fresh.matcher_path = matcher.path;
  return &levels_.emplace_back(std::move(fresh));
}

}  // namespace xgm
