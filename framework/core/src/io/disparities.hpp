// SPDX-License-Identifier: Apache-2.0
// From the values of a file to disparities.
#pragma once

#include <opencv2/core.hpp>

#include "io/unscaled_image.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm {

/// Throws Error if the file is a colour picture: maps have one channel, or equal ones.
void require_no_picture(const UnscaledImage& raster);

/// value / divisor, NaN where there is none: no data, 0 in a file of whole numbers, marks.
Noted<cv::Mat1f> to_disparities(UnscaledImage raster, double divisor);

}  // namespace xgm
