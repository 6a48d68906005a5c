// SPDX-License-Identifier: Apache-2.0
// What is true of a scene, to judge maps by.
#pragma once

#include <opencv2/core.hpp>

namespace xgm {

/// Maps of one size; those that are not known are empty.
struct GroundTruth {
  cv::Mat1f disparity{};     ///< of the left view, px; not finite = unknown
  cv::Mat1f reverse{};       ///< of the right view, with the signs of a reverse map (negative)
  cv::Mat1b non_occluded{};  ///< 255 where a left pixel is seen in the right image, too
  cv::Mat1b objects{};       ///< not zero on moving objects (KITTI's foreground)
};

}  // namespace xgm
