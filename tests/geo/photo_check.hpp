// SPDX-License-Identifier: Apache-2.0
// Does a surface fit the images it was made of? Needs no truth and no other program.
#pragma once

#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/image/satellite_image.hpp"

namespace xgm::testing {

/// Where the second image shows patches of the surface, compared with where it should: median over
/// many patches of the best correlation's place, px, along the epipolar line and across it.
struct PhotoCheck {
  double along = 0;
  double across = 0;
  int patches = 0;
};
PhotoCheck photo_check(const geo::Raster& surface, const geo::SatelliteImage& first,
                       const geo::SatelliteImage& second);

}  // namespace xgm::testing
