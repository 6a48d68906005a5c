// SPDX-License-Identifier: Apache-2.0
// The median of windows of 3x3 pixels, the window that nearly everybody wants.
#pragma once

#include <opencv2/core.hpp>

namespace xgm::median {

/// Writes row y: where there is a disparity, the median of those in the 3x3 window, the lower of
/// the two middle ones of an even number; elsewhere NaN. Outside of the map there are none.
void three_by_three(const cv::Mat1f& disparity, int y, float* result);

}  // namespace xgm::median
