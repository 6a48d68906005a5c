// SPDX-License-Identifier: Apache-2.0
// How often a surface leaves the true one where that is level.
#pragma once

#include <opencv2/core.hpp>

#include "xgm/base/export.hpp"

namespace xgm::geo {

struct SpikeRules {
  double reach = 5;  ///< m around a cell of a flat
  double level = 1;  ///< m that true heights differ by there, at most
  double size = 5;   ///< m off the truth: a spike
};

/// Share of the cells on flats that have a height and are spikes, 0 to 1; NaN if there is no such
/// cell. Both maps on one grid of `posting` m, NaN = none; a flat has a true height everywhere.
XGM_API double spikes_on_flats(const cv::Mat1f& surface, const cv::Mat1f& truth, double posting,
                               const SpikeRules& rules = {});

}  // namespace xgm::geo
