// SPDX-License-Identifier: Apache-2.0
// A collection of satellite images, as it comes together over several dates.
#pragma once

#include <vector>

#include "xgm/geo/synthesis/satellite_scene.hpp"

namespace xgm::geo {

struct ViewPlan {
  int images = 2;             ///< at least 2
  int dates = 2;              ///< 1 to `images`; the images of a date have one sun
  double incidence = 10;      ///< mean of the images, degrees from straight above, 0 to 40
  double sun_elevation = 45;  ///< mean of the dates, degrees, 5 to 80
  double pointing_error = 0;  ///< standard deviation, along and across epipolar lines, px
};

/// Images from all around the place, the angles scattered by some degrees; dates differ in the
/// sun's place, in cars and in the brightness of vegetation. The same seed gives the same images.
/// Throws UsageError, which names the value that is out of its range.
XGM_API std::vector<SatelliteView> plan_views(const ViewPlan& plan, std::uint64_t seed);

}  // namespace xgm::geo
