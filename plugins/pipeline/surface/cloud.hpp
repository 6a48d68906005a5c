// SPDX-License-Identifier: Apache-2.0
// The points of all windows of a pair.
#pragma once

#include <vector>

#include "xgm/data/disparity_map.hpp"
#include "xgm/geo/image/point_cloud.hpp"
#include "xgm/geo/image/point_grid.hpp"
#include "xgm/geo/image/rectified_pair.hpp"
#include "xgm/geo/stage/surface.hpp"

namespace xgm::geo {

/// Adds those whose pixel lies in the window of the base image; x and y are longitude and latitude.
void append(PointCloud& cloud, const PointGrid& points, const DisparityMap& map,
            const cv::Mat1f& grey, const Rectification& geometry, const cv::Rect& window);

/// Longitudes and latitudes become x and y of the grid's CRS.
void move_to_grid(PointCloud& cloud, const CrsTransform& to_grid);

/// The same places with other values for heights.
GridPoints with_values(GridPoints points, const std::vector<float>& values);

}  // namespace xgm::geo
