// SPDX-License-Identifier: Apache-2.0
// The points of all windows of a pair.
#pragma once

#include <vector>

#include "xgm/geo/image/point_grid.hpp"
#include "xgm/geo/image/rectified_pair.hpp"
#include "xgm/geo/stage/surface.hpp"

namespace xgm::geo {

struct Cloud {
  std::vector<GeoPoint> points;
  std::vector<float> greys;
};

/// Adds those whose pixel lies in the window of the base image.
void append(Cloud& cloud, const PointGrid& points, const cv::Mat1f& grey,
            const Rectification& geometry, const cv::Rect& window);

/// In the CRS of a grid.
GridPoints on_grid(const Cloud& cloud, const CrsTransform& to_grid);
/// The same places with grey levels for heights.
GridPoints with_greys(GridPoints points, const Cloud& cloud);

}  // namespace xgm::geo
