// SPDX-License-Identifier: Apache-2.0
// What a true surface says of a run.
#pragma once

#include <vector>

#include "xgm/geo/run/recorded_surface.hpp"

namespace xgm::geo {

/// Keeps the maps of a run until it has ended: judging them takes time that is not the run's.
class TruthRecord {
 public:
  /// Throws UsageError if the file cannot be read, or says no place on the ground.
  explicit TruthRecord(const std::string& file);
  void add(const RectifiedPair& pair, const DisparityMap& map) { windows_.push_back({pair, map}); }

  /// Of the fused surface, and of the disparities. What cannot be judged is left out, and a warning
  /// says why.
  SurfaceTruth judge(const SurfaceResult& result, Observer& observer) const;

 private:
  struct Window {
    RectifiedPair pair;
    DisparityMap map;
  };
  Raster truth_;
  std::vector<Window> windows_;
};

}  // namespace xgm::geo
