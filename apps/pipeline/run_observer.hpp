// SPDX-License-Identifier: Apache-2.0
// Shows, dumps and records what happens in a run.
#pragma once

#include "progress.hpp"
#include "xgm/report.hpp"
#include "xgm/run_record.hpp"

namespace xgm::cli {

class RunObserver final : public RunRecorder {
 public:
  /// `levels` may be null: nobody will look at them.
  RunObserver(Progress& progress, Dumper& dumper, LevelCollector* levels)
      : progress_(progress), dumper_(dumper), levels_(levels) {}

  void log(LogLevel level, const std::string& stage_path, const std::string& text) override;
  void stage_begin(const std::string& stage_path, const std::string& plugin) override;
  void stage_end(const std::string& stage_path, const StageStatistics& statistics,
                 const Artifact& result) override;
  void report(const std::string& stage_path, const std::string& name, double value) override;
  void progress(double share) override { progress_.share(share); }

 private:
  Progress& progress_;
  Dumper& dumper_;
  LevelCollector* levels_;
};

}  // namespace xgm::cli
