// SPDX-License-Identifier: Apache-2.0
// Which pixels are filled as occluded ones.
#pragma once

#include "xgm/data/disparity_map.hpp"

namespace xgm::discontinuity_preserving_interpolation {

/// Non-zero for occluded pixels and, if `spread`, for mismatched pixels linked to an occluded one
/// by 4-connected mismatched pixels: they too must be extrapolated from the background.
cv::Mat1b occlusions(const DisparityMap& map, bool spread);

}  // namespace xgm::discontinuity_preserving_interpolation
