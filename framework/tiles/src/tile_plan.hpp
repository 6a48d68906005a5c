// SPDX-License-Identifier: Apache-2.0
// What a process takes that matches in tiles.
#pragma once

#include "xgm/pipeline/plan.hpp"
#include "xgm/tiles/tiled_run.hpp"

namespace xgm::tiles {

/// Seconds cost one more small run, and a look at the speed of the machine.
enum class PlanOf { memory, memory_and_seconds };

/// Seconds of a plan without those of preprocess stages.
double matching_seconds(const RunPlan& plan);

class TilePlan {
 public:
  /// Watches a small run of the scene.
  TilePlan(const Pipeline& pipeline, const TiledRequest& request, const Besides& besides,
           const RunOptions& options, PlanOf what = PlanOf::memory);

  /// Of one tile of the largest size, and of the coarse levels, of which there may be none.
  RunPlan tile(const TileOptions& tiles) const;
  RunPlan coarse(const TileOptions& tiles) const;
  /// Of what preprocess stages look at the whole scene for.
  struct Fit {
    double bytes = 0, seconds = 0;
  };
  Fit fit() const;
  /// The most that is taken at a time: for a tile, for the coarse levels, or after them.
  double bytes(const TileOptions& tiles) const;
  /// The same of a run without tiles.
  double bytes_of_whole(const Besides& besides, bool truth) const;

 private:
  TilePlan(const Pipeline& pipeline, const MatchRequest& small, const TiledRequest& request,
           const Besides& besides, const RunOptions& options, PlanOf what);
  RunPlan plan_of(cv::Size size, Interval range, double used, double held,
                  bool volumes_stay = false) const;
  int scale_of(const TileOptions& tiles) const;

  const Pipeline& pipeline_;
  Workload load_;  ///< of the whole
  RunTrace trace_;
  Besides besides_;
};

}  // namespace xgm::tiles
