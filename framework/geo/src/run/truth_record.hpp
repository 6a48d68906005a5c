// SPDX-License-Identifier: Apache-2.0
// What a true surface says of a run.
#pragma once

#include <vector>

#include "xgm/geo/run/recorded_surface.hpp"

namespace xgm::geo {

/// Keeps the maps of a run until it has ended: judging them takes time that is not the run's.
class TruthRecord {
 public:
  /// Throws Error if the file cannot be read.
  explicit TruthRecord(const std::string& file) : truth_(read_raster(file)) {}
  void add(const RectifiedPair& pair, const DisparityMap& map) { windows_.push_back({pair, map}); }

  /// Of the fused surface, and of the disparities. What cannot be judged is left out, and
  /// `warnings` say why.
  SurfaceTruth judge(const SurfaceResult& result, std::vector<std::string>& warnings) const;

 private:
  struct Window {
    RectifiedPair pair;
    DisparityMap map;
  };
  Raster truth_;
  std::vector<Window> windows_;
};

}  // namespace xgm::geo
