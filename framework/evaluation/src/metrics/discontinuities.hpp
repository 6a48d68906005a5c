// SPDX-License-Identifier: Apache-2.0
// Where the true disparity jumps.
#pragma once

#include <opencv2/core.hpp>

namespace xgm {

/// 255 near jumps of the disparity, as regions_of defines them for "near discontinuities" (occluded
/// pixels included). Jumps to pixels whose disparity is not finite are not known and do not count.
cv::Mat1b near_discontinuities(const cv::Mat1f& disparity);

}  // namespace xgm
