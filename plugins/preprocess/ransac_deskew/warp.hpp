// SPDX-License-Identifier: Apache-2.0
// Moves the pixels of an image up and down, so that its rows align with those of the other view.
#pragma once

#include "plugins/preprocess/ransac_deskew/row_model.hpp"
#include "xgm/data/image.hpp"

namespace xgm::ransac_deskew {

/// The image whose pixel (x, y) is that at (x, y + dy(x, y)) of `image`, cubically interpolated.
/// Masked where that lies outside, or where a pixel without data would take part. The model is
/// about an image in which this one begins at `origin`.
Image warp_rows(const Image& image, const RowModel& model, cv::Point origin = {});

}  // namespace xgm::ransac_deskew
