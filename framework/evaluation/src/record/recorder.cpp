// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "xgm/evaluation/run_record.hpp"

namespace xgm {
namespace {

/// The latest call of the stage at `path`; null if there was none.
StageRecord* latest(std::vector<StageRecord>& stages, const std::string& path, bool unfinished) {
  const auto found = std::find_if(stages.rbegin(), stages.rend(), [&](const StageRecord& stage) {
    return stage.path == path && !(unfinished && stage.finished);
  });
  return found == stages.rend() ? nullptr : &*found;
}

}  // namespace

void RunRecorder::stage_begin(const std::string& stage_path, const std::string& plugin) {
  stages_.push_back({stage_path, plugin, {}, false, {}});
}

void RunRecorder::stage_end(const std::string& stage_path, const StageStatistics& statistics,
                            const Artifact&) {
  StageRecord* stage = latest(stages_, stage_path, true);
  if (stage == nullptr) return;
  stage->statistics = statistics;
  stage->finished = true;
}

void RunRecorder::report(const std::string& stage_path, const std::string& name, double value) {
  StageRecord* stage = latest(stages_, stage_path, false);
  if (stage == nullptr) {
    // Told from inside a scope that is no stage of its own: kept under the scope's path.
    stage = &stages_.emplace_back();
    stage->path = stage_path;
  }
  stage->figures.emplace_back(name, value);
}

}  // namespace xgm
