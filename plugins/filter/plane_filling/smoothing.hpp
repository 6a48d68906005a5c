// SPDX-License-Identifier: Apache-2.0
// Grey levels without most of the image noise, which would part segments.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "xgm/data/image.hpp"

namespace xgm::plane_filling {

/// The planes of the image, means over 3x3 pixels weighted by 1 2 1 in both directions. Pixels
/// without data have no weight; what they get means nothing.
std::vector<cv::Mat1f> smoothed(const Image& image);

}  // namespace xgm::plane_filling
