// SPDX-License-Identifier: Apache-2.0
// Several observers of one run.
#pragma once

#include <vector>

#include "xgm/stage/context.hpp"

namespace xgm {

/// Tells each of them, in the order in which they were added, all that it is told.
class XGM_API Observers final : public Observer {
 public:
  /// `observer` outlives the run.
  void add(Observer& observer) { observers_.push_back(&observer); }

  void log(LogLevel level, const StagePlace& place, const std::string& text) override;
  void stage_begin(const StagePlace& place) override;
  void stage_input(const StagePlace& place, const Artifact& input) override;
  void stage_same_as(const StagePlace& place, const std::string& earlier) override;
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;
  void figure(const StagePlace& place, const std::string& name, double value) override;
  void progress(double share) override;

 private:
  std::vector<Observer*> observers_;
};

}  // namespace xgm
