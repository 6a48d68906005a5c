// SPDX-License-Identifier: Apache-2.0
// A first look: the surface at a quarter of the resolution, by which a finer search is bounded.
#pragma once

#include "plugins/pipeline/surface/stages.hpp"
#include "xgm/geo/stage/surface_family.hpp"

namespace xgm::geo {

/// Of the same pairs by the same stages, but images whose pixels are means of 4 x 4, which `prior`
/// bounds. Covers somewhat more than what is asked for, so that windows have a surface up to their
/// borders. Without cells, and with a warning, if nothing could be matched.
Raster coarse_surface(const SurfaceStages& stages, const Slot<RangePrior>& prior,
                      const SurfaceRequest& request, const std::vector<SatelliteImage>& images,
                      const std::vector<PairChoice>& pairs, const Context& context);

}  // namespace xgm::geo
