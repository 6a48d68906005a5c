// SPDX-License-Identifier: Apache-2.0
// What a DEM of far lower resolution says of the same ground.
#pragma once

#include "synthesis/landscape.hpp"
#include "synthesis/map_frame.hpp"

namespace xgm::geo {

/// Means of the surface's cells, buildings and trees included, in the datum of the spec, with its
/// bias and error; independent from cell to cell.
Raster coarse_dem(const SatelliteSceneSpec& spec, const Landscape& land, const MapFrame& frame);

}  // namespace xgm::geo
