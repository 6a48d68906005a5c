// SPDX-License-Identifier: Apache-2.0
// Shows, dumps and records what happens in a run.
#pragma once

#include <vector>

#include "progress.hpp"
#include "xgm/evaluation/run_record.hpp"

namespace xgm::cli {

class RunObserver final : public RunRecorder {
 public:
  RunObserver(Progress& progress, Dumper& dumper) : progress_(progress), dumper_(dumper) {}

  /// All of it also goes to `other`, which outlives the run.
  void show_to(Observer& other) { others_.push_back(&other); }

  void log(LogLevel level, const StagePlace& place, const std::string& text) override;
  void stage_begin(const StagePlace& place) override;
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;
  void stage_input(const StagePlace& place, const Artifact& input) override;
  void figure(const StagePlace& place, const std::string& name, double value) override;
  void progress(double share) override { progress_.share(share); }

 private:
  Progress& progress_;
  Dumper& dumper_;
  std::vector<Observer*> others_;
};

}  // namespace xgm::cli
