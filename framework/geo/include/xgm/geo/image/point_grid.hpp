// SPDX-License-Identifier: Apache-2.0
// The points of a disparity map on the ground.
#pragma once

#include <opencv2/core.hpp>

namespace xgm::geo {

/// One point per pixel of the rectified base image. Pixels without a point have NaN.
struct PointGrid {
  cv::Mat3d ecef;  ///< m
  cv::Mat1f gap;   ///< shortest distance of the two lines of sight, m
  cv::Mat1f grey;  ///< of the base image
};

}  // namespace xgm::geo
