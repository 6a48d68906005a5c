// SPDX-License-Identifier: Apache-2.0
// Ground truth of a scene, with which maps are compared.
#pragma once

#include <opencv2/core.hpp>

namespace xgm {

/// Maps of one size. A map that is unknown is empty.
struct GroundTruth {
  cv::Mat1f disparity{};     ///< of the left view, px; not finite = unknown
  cv::Mat1f reverse{};       ///< of the right view, with the signs of a reverse map (negative)
  cv::Mat1b non_occluded{};  ///< 255 where a left pixel is also visible in the right image
  cv::Mat1b objects{};       ///< nonzero on moving objects (KITTI's foreground)
};

}  // namespace xgm
