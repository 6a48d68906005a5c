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

/// Bands of whole rows that cover an image once, from the top, for looks at all of it that hold
/// little: of a megapixel or a few. Each but the last has a multiple of `alignment` rows.
XGM_API std::vector<cv::Rect> row_bands(cv::Size image, int alignment = 1);

}  // namespace xgm
