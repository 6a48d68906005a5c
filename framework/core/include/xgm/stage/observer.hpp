// SPDX-License-Identifier: Apache-2.0
// Who is told what happens in a run.
#pragma once

#include <cstddef>
#include <string>
#include <variant>

#include "xgm/base/export.hpp"
#include "xgm/data/match.hpp"
#include "xgm/data/volume.hpp"
#include "xgm/stage/place.hpp"

namespace xgm {

enum class LogLevel { debug, info, warning };

/// What a stage is given or has produced, shown to the observer while it lives. A cv::Mat1f is a
/// confidence.
using Artifact = std::variant<std::monostate, const ImagePair*, const DisparityRange*,
                              const CostVolume*, const AggregatedVolume*, const DisparityMap*,
                              const MatchResult*, const MatchRequest*, const cv::Mat1f*>;

struct StageStatistics {
  double seconds = 0;     ///< wall time, stages inside included
  std::size_t bytes = 0;  ///< size of what the stage returned
};

/// All functions may be left as they are. Called from the thread that runs the pipeline, never from
/// several at once.
class XGM_API Observer {
 public:
  virtual ~Observer();
  virtual void log(LogLevel level, const StagePlace& place, const std::string& text);
  virtual void stage_begin(const StagePlace& place);
  virtual void stage_end(const StagePlace& place, const StageStatistics& statistics,
                         const Artifact& result);
  /// A figure that a stage found ("dy_before", 1.3), for the run's record.
  virtual void figure(const StagePlace& place, const std::string& name, double value);
  /// Share of the whole run that is done, 0 to 1, never falling.
  virtual void progress(double share);
  /// After stage_begin, once for each input that is an artifact, in the order of run's parameters.
  /// It lives until stage_end.
  virtual void stage_input(const StagePlace& place, const Artifact& input);
  /// Between stage_begin and stage_end: this one is equal to the stage at the path `earlier`, was
  /// asked the same, and returns what that has found. No stages inside it run.
  virtual void stage_same_as(const StagePlace& place, const std::string& earlier);
};

}  // namespace xgm
