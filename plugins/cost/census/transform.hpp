// SPDX-License-Identifier: Apache-2.0
// The census transform of one image row: a bit string per pixel.
#pragma once

#include "plugins/cost/candidate_costs/candidates.hpp"

namespace xgm::census {

/// Bit strings of the pixels of a row, one bit per neighbour in the window and channel. They are
/// cut into bytes, plane k holding byte k of all pixels: so a vector compares as many pixels as it
/// has bytes, and bits are counted without widening. Every channel begins with a byte of its own.
using Descriptors = cost::PixelRow<std::uint8_t>;

/// Row y of an image by Zabih & Woodfill 1994: a bit is set where the neighbour is darker than the
/// centre; equal is not darker. A neighbour that does not exist (outside the image, or masked) sets
/// no bit. `window` has odd sides. The bit string of a masked pixel has no meaning; those of a
/// mirrored row are the same as if it were not.
Descriptors transform(const Image& image, int y, cv::Size window, const cost::RowLayout& layout);

}  // namespace xgm::census
