// SPDX-License-Identifier: Apache-2.0
// From pairs of images to points on the ground, window by window.
#pragma once

#include <vector>

#include "plugins/pipeline/surface/reasons.hpp"
#include "plugins/pipeline/surface/stages.hpp"
#include "xgm/geo/stage/surface_family.hpp"

namespace xgm::geo {

/// One element of each vector per pair.
struct MatchedPairs {
  std::vector<SeenPair> seen;
  std::vector<PointCloud> clouds;  ///< x and y are longitude and latitude
};

/// `images` are those of the request, with cameras that have been corrected; `prior` bounds the
/// search. If it asks for one, the surface of a run at a quarter of the resolution is made first.
MatchedPairs match_pairs(const SurfaceStages& stages, const Slot<RangePrior>& prior,
                         const SurfaceRequest& request, const std::vector<SatelliteImage>& images,
                         const std::vector<PairChoice>& pairs, const Context& context);

/// What match_pairs() is going to match. Only a coarser surface, if the prior asks for one, is
/// matched for it.
WorkAhead look_ahead(const SurfaceStages& stages, const SurfaceRequest& request,
                     const std::vector<SatelliteImage>& images,
                     const std::vector<PairChoice>& pairs, const Context& context);

}  // namespace xgm::geo
