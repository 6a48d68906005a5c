// SPDX-License-Identifier: Apache-2.0
// What makes a truth look as if it were not that of the map.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"

namespace xgm {

/// A sentence, with the remedy, if the true disparities (px, not finite = unknown) have the other
/// sign than the map's, or else if a good part of them lies outside of what was searched (empty:
/// not known). The map has their size.
XGM_API std::vector<std::string> truth_doubts(const DisparityMap& map, const cv::Mat1f& truth,
                                              Interval searched);

}  // namespace xgm
