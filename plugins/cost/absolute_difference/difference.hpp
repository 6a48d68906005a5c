// SPDX-License-Identifier: Apache-2.0
// |a - b| of grey levels: the inner loop of the cost.
#pragma once

#include "plugins/cost/candidate_costs/candidates.hpp"

namespace xgm::absolute_difference {

/// The grey levels of an image row, a plane per channel.
cost::PixelRow<float> levels(const Image& image, int y, const cost::RowLayout& layout);

/// Writes row y of the volume: the mean over the channels of the absolute difference, truncated.
void compare(const cost::RowPair<float>& rows, int y, float truncation, CostVolume& costs);

}  // namespace xgm::absolute_difference
