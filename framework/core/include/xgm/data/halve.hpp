// SPDX-License-Identifier: Apache-2.0
// One level of the pyramid from the next finer one. Coarse pixel (x, y) covers the fine pixels
// (2x, 2y) to (2x + 1, 2y + 1), so disparities halve exactly; sizes are rounded up.
#pragma once

#include "xgm/base/export.hpp"
#include "xgm/data/match.hpp"

namespace xgm {

/// Mean of the (up to four) valid fine pixels; a coarse pixel is valid if any of them is, so that
/// masks never grow and every fine pixel with data has a coarse one that knows something of it.
XGM_API Image halve(const Image& fine);

/// Contains half of every disparity that a covered pixel searches: from the smallest begin to the
/// largest last disparity, halved and rounded outwards. Pixels with an empty interval have no say;
/// where all are empty the coarse one is. Repeated, this rounds as the paper's Table 1 does:
/// floor(d_min / s) to ceil(d_max / s).
XGM_API DisparityRange halve(const DisparityRange& fine);

/// The whole question at half the resolution.
XGM_API MatchRequest halve(const MatchRequest& fine);

}  // namespace xgm
