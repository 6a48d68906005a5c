// SPDX-License-Identifier: Apache-2.0
// Which grey levels a pixel takes within half a pixel to the left and to the right.
#pragma once

#include "plugins/cost/candidate_costs/candidates.hpp"

namespace xgm::birchfield_tomasi {

/// Planes of each channel: the grey level, and the least and greatest that the linearly
/// interpolated row takes within half a pixel.
enum Intensity { kValue, kLow, kHigh, kIntensities };

/// Row y of all channels. Towards a neighbour that is masked or outside, the level stays the same.
cost::PixelRow<float> intensity_rows(const Image& image, int y, const cost::RowLayout& layout);

}  // namespace xgm::birchfield_tomasi
