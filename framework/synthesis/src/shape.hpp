// SPDX-License-Identifier: Apache-2.0
// Surfaces in the space (x, y, d) of base pixels and disparities.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>

namespace xgm::synthesis {

/// The points (x + slope * d, y, d): what a pixel of the base (slope 0) or of the match view
/// (slope 1) sees. Lines of sight are straight in this space, as it is a projective image of the
/// world's; for the same reason planes, ellipsoids, cylinders ... are such here and there.
struct Ray {
  double x = 0;
  double slope = 0;
  double y = 0;
};

/// A point of a surface in its own coordinates.
struct Hit {
  double disparity = 0;
  double u = 0, v = 0, w = 0;
};

/// Which part of a surface is there.
struct Outline {
  enum class Kind { everywhere, rectangle, ellipse, ragged, fence, wire };
  Kind kind = Kind::everywhere;
  std::uint64_t key = 0;  ///< ragged: of the noise
  double spacing = 10;    ///< px; of the fence's bars, of the leaves of ragged
  double thickness = 1;   ///< px; of bars and wires
};

/// a u^2 + b v^2 + c w^2 + e w = g, where u and v are base coordinates about the centre, turned to
/// `axis`, in units of `half`; w is the disparity less that of the slanted plane through the
/// centre, in units of `depth`. Any such surface meets a ray where a quadratic equation holds.
struct Shape {
  enum class Form { plane, saddle, ellipsoid, cylinder };  ///< the cylinder's axis is that of v
  Form form = Form::plane;
  cv::Point2d centre{0, 0};
  double d = 0;
  double slope_x = 0, slope_y = 0;  ///< px of disparity per px; slope_x < 1
  cv::Point2d axis{1, 0};           ///< of u, length 1
  cv::Point2d half{1, 1};           ///< px
  double depth = 1;                 ///< px; 1 for planes and saddles
  double bend_u = 0, bend_v = 0;    ///< saddle: w = bend_u u^2 + bend_v v^2; px
  Outline outline;

  /// The nearest point on the ray that is there. Solved, not iterated.
  std::optional<Hit> meet(const Ray& ray) const;
  /// Cheap: no point of the shape can be on the ray. `row_only` looks at ray.y alone.
  bool misses(const Ray& ray, bool row_only = false) const;
  bool covers(double u, double v) const;
};

}  // namespace xgm::synthesis
