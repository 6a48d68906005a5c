// SPDX-License-Identifier: Apache-2.0
// Shows what happens in a run.
#pragma once

#include "terminal/progress.hpp"
#include "xgm/pipeline/scene_inputs.hpp"
#include "xgm/stage/context.hpp"

namespace xgm::cli {

class TerminalObserver final : public Observer {
 public:
  explicit TerminalObserver(Progress& progress) : progress_(progress) {}

  void log(LogLevel level, const StagePlace& place, const std::string& text) override;
  void stage_begin(const StagePlace& place) override;
  void stage_same_as(const StagePlace& place, const std::string& earlier) override;
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;
  void figure(const StagePlace& place, const std::string& name, double value) override;
  void progress(double share) override { progress_.share(share); }

 private:
  Progress& progress_;
};

/// What a run of this scene would tell before it begins, for commands that run it otherwise.
void show_notes(const SceneInputs& inputs);

}  // namespace xgm::cli
