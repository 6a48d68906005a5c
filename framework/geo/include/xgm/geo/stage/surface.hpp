// SPDX-License-Identifier: Apache-2.0
// Kind "surface": from points to heights on a grid.
#pragma once

#include <string_view>
#include <vector>

#include "xgm/geo/ground/raster.hpp"
#include "xgm/plugin.hpp"

namespace xgm::geo {

/// A grid on the ground.
struct GridSpec {
  Crs crs;  ///< horizontal, in metres
  GridPlace place;
  cv::Size size;  ///< cells
};

/// x and y in the CRS of a grid, and the height above the ellipsoid, m.
using GridPoints = std::vector<cv::Vec3d>;

class XGM_API Surface : public Stage {
 public:
  static constexpr std::string_view kKind = "surface";
  static constexpr std::string_view kMeaning = "makes a grid of heights of points";

  /// Heights of the grid's size; NaN where no point says one.
  virtual Raster run(const GridPoints& points, const GridSpec& grid,
                     const Context& context) const = 0;
};

}  // namespace xgm::geo
