// SPDX-License-Identifier: Apache-2.0
// The publication's dissimilarity of pixels: the inner loop of the cost.
#pragma once

#include "plugins/cost/candidate_costs/candidates.hpp"

namespace xgm::birchfield_tomasi {

/// Writes row y of the volume: the mean over the channels of d(x_L, x_R), truncated. Rows are those
/// of intensity_rows().
void compare(const cost::RowPair<float>& rows, int y, float truncation, CostVolume& costs);

}  // namespace xgm::birchfield_tomasi
