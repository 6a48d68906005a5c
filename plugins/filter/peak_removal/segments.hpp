// SPDX-License-Identifier: Apache-2.0
// Sizes of the segments of a disparity map.
#pragma once

#include <opencv2/core.hpp>

namespace xgm::peak_removal {

/// For each pixel the number of pixels in its segment, 0 where the disparity is NaN. Pixels with a
/// disparity are in one segment if a chain of 4-connected neighbours links them whose disparities
/// differ by at most `max_difference` pixels from one to the next.
cv::Mat1i segment_sizes(const cv::Mat1f& disparity, double max_difference);

}  // namespace xgm::peak_removal
