// SPDX-License-Identifier: Apache-2.0
// What a process takes that matches in tiles.
#pragma once

#include "xgm/pipeline/plan.hpp"
#include "xgm/tiles/tiled_run.hpp"

namespace xgm::tiles {

class TilePlan {
 public:
  /// Watches a small run of the scene.
  TilePlan(const Pipeline& pipeline, const TiledRequest& request, const Besides& besides,
           const RunOptions& options);

  /// The most that is taken at a time: for a tile, for the coarse levels, or after them.
  double bytes(const TileOptions& tiles) const;
  /// The same of a run without tiles.
  double bytes_of_whole(const Besides& besides, bool truth) const;

 private:
  TilePlan(const Pipeline& pipeline, const MatchRequest& small, const TiledRequest& request,
           const Besides& besides, const RunOptions& options);
  double bytes_of(cv::Size size, Interval range, double held) const;

  const Pipeline& pipeline_;
  Workload load_;  ///< of the whole
  RunTrace trace_;
  Besides besides_;
};

}  // namespace xgm::tiles
