// SPDX-License-Identifier: Apache-2.0
// Real heights in place of a generated landscape, and what covers them.
#pragma once

#include "synthesis/landscape.hpp"

namespace xgm::geo {

/// The heights of spec.relief_file above its lowest place; cells without one are as high as the
/// nearest that has one in their row. The place has the posting of the file, or that of the spec if
/// it has no georeference. Throws UsageError for a georeference that is not in metres, and Error
/// for a file without heights.
Raster read_relief(const SatelliteSceneSpec& spec);

/// Fills land.heights with the relief, its middle in the middle of the grid, mirrored at its
/// borders where the grid is larger; and says what covers it: what stands above the ground is a
/// roof where it is smooth, else a tree; what is left and smooth is flat.
void take_relief(const SatelliteSceneSpec& spec, Landscape& land);

}  // namespace xgm::geo
