// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "xgm/evaluation/run_record.hpp"

namespace xgm {
namespace {

/// The latest call of the stage at `path`; null if there was none.
StageRecord* latest(std::vector<StageRecord>& stages, const std::string& path, bool unfinished) {
  const auto found = std::find_if(stages.rbegin(), stages.rend(), [&](const StageRecord& stage) {
    return stage.place.path == path && !(unfinished && stage.finished);
  });
  return found == stages.rend() ? nullptr : &*found;
}

StageRecord& add(std::vector<StageRecord>& stages, const StagePlace& place) {
  StageRecord& stage = stages.emplace_back();
  stage.place = place;
  stage.place.stage = nullptr;
  return stage;
}

}  // namespace

void RunRecorder::stage_begin(const StagePlace& place) { add(stages_, place); }

void RunRecorder::stage_end(const StagePlace& place, const StageStatistics& statistics,
                            const Artifact&) {
  StageRecord* stage = latest(stages_, place.path, true);
  if (stage == nullptr) return;
  stage->statistics = statistics;
  stage->finished = true;
}

void RunRecorder::stage_same_as(const StagePlace& place, const std::string& earlier) {
  if (StageRecord* const stage = latest(stages_, place.path, true)) stage->same_as = earlier;
}

void RunRecorder::figure(const StagePlace& place, const std::string& name, double value) {
  StageRecord* stage = latest(stages_, place.path, false);
  // Told from inside a scope that is no stage of its own: kept under the scope's path.
  if (stage == nullptr) stage = &add(stages_, place);
  stage->figures.emplace_back(name, value);
}

}  // namespace xgm
