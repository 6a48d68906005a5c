// SPDX-License-Identifier: Apache-2.0
// Directions in the sky as a picture.
#pragma once

#include <string>
#include <vector>

namespace xgm::geo {

struct SkyPoint {
  std::string name;
  double azimuth = 0;  ///< degrees, north is 0, east 90
  double zenith = 0;   ///< degrees from straight above
};

/// An SVG, north up, straight above in the middle. `outermost`: degrees of the last circle; points
/// beyond it stand on it.
std::string polar_plot(const std::string& title, const std::vector<SkyPoint>& points,
                       double outermost);

}  // namespace xgm::geo
