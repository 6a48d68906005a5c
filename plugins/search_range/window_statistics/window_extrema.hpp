// SPDX-License-Identifier: Apache-2.0
// Smallest and largest disparity around each pixel.
#pragma once

#include "plugins/search_range/window_statistics/proposal.hpp"
#include "xgm/data/disparity_map.hpp"

namespace xgm::search_range {

/// For each pixel that has a disparity: from the smallest to the largest disparity in the
/// window x window pixels around it, relaxed. Other pixels propose nothing. `window` is odd.
Proposal window_extrema(const DisparityMap& coarse, int window, int relaxation);

}  // namespace xgm::search_range
