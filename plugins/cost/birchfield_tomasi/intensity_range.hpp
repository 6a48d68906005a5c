// SPDX-License-Identifier: Apache-2.0
// Which grey levels a pixel takes within half a pixel to the left and to the right.
#pragma once

#include <vector>

#include "xgm/data/image.hpp"

namespace xgm::birchfield_tomasi {

/// Grey levels of the pixels of a row, and the least and greatest that the linearly interpolated
/// row takes within half a pixel of each.
struct IntensityRow {
  std::vector<float> value, low, high;
};

/// Row y of one channel. Towards a neighbour that is masked or outside, the level stays the same.
IntensityRow intensity_row(const Image& image, std::size_t channel, int y);

/// The same row from right to left.
IntensityRow mirrored(IntensityRow row);

}  // namespace xgm::birchfield_tomasi
