// SPDX-License-Identifier: Apache-2.0
// An image cut into parts.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// Parts that cover an image once: of about the same size, none larger than `largest`, row by row.
/// Their left and upper sides are multiples of `alignment`.
XGM_API std::vector<cv::Rect> image_parts(cv::Size image, cv::Size largest, int alignment = 1);

}  // namespace xgm
