// SPDX-License-Identifier: Apache-2.0
// A flat textured thing in a generated scene, described in base image coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

namespace xgm::testing::detail {

/// d(x, y) = d + slope_x * (x - centre.x) + slope_y * (y - centre.y), slope_x < 1: closed under the
/// change of view, so that both views are exact.
struct Plane {
  cv::Point2d centre;
  double d = 0;
  double slope_x = 0;
  double slope_y = 0;

  double at(double x, double y) const {
    return d + slope_x * (x - centre.x) + slope_y * (y - centre.y);
  }
  /// The base column x that is seen in column x - at(x, y) of the match image.
  double base_column(double x_match, double y) const {
    return (x_match + at(0, y)) / (1 - slope_x);
  }
};

struct Surface {
  enum class Outline { everywhere, rectangle, ellipse };

  Plane plane;
  Outline outline = Outline::everywhere;
  cv::Point2d half{0, 0};  ///< half width and height of the outline around plane.centre
  std::uint64_t texture = 0;
  std::array<double, 3> level{128, 128, 128};  ///< mean level of each image plane
  double contrast = 160;

  bool covers(double x, double y) const;
  /// Grey level of image plane `channel` at a point of the base image.
  double colour(int channel, double x, double y) const;
};

/// The surface seen along a line of sight, its disparity, and the base column it is seen at.
struct Sight {
  int surface = 0;
  double x = 0;
  double disparity = -std::numeric_limits<double>::infinity();
};

/// What the base view shows at (x, y). The first surface must cover everything.
Sight look_base(const std::vector<Surface>& surfaces, double x, double y);
/// What the match view shows at (x_match, y), rows aligned.
Sight look_match(const std::vector<Surface>& surfaces, double x_match, double y);

}  // namespace xgm::testing::detail
