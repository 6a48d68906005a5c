// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/run/relief.hpp"

#include <algorithm>
#include <cmath>

#include "xgm/io/outputs.hpp"

namespace xgm::geo {
namespace {

/// 0 to 1: how much light falls on a cell. Cells beside holes are taken as flat.
cv::Mat1f hill_shade(const cv::Mat1f& heights, double step) {
  constexpr float kFlat = 0.75F;
  const cv::Vec3d sun = cv::normalize(cv::Vec3d(-1, -1, std::sqrt(2.0)));  // east, south, up
  cv::Mat1f light(heights.size(), kFlat);
  for (int y = 1; y + 1 < heights.rows; ++y) {
    for (int x = 1; x + 1 < heights.cols; ++x) {
      const double dx = (double{heights(y, x + 1)} - double{heights(y, x - 1)}) / (2 * step);
      const double dy = (double{heights(y + 1, x)} - double{heights(y - 1, x)}) / (2 * step);
      if (std::isnan(dx) || std::isnan(dy)) continue;
      const double shade = cv::normalize(cv::Vec3d(-dx, -dy, 1)).dot(sun);
      light(y, x) = static_cast<float>(std::clamp(0.25 + 0.75 * shade, 0.0, 1.0));
    }
  }
  return light;
}

}  // namespace

cv::Mat3b relief_picture(const Raster& surface) {
  return colour_picture(surface.values, "m", hill_shade(surface.values, surface.place.step_x));
}

}  // namespace xgm::geo
