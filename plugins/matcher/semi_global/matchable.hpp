// SPDX-License-Identifier: Apache-2.0
// Which disparities of a range stay inside the match image.
#pragma once

#include "xgm/data/disparity_range.hpp"

namespace xgm::semi_global {

/// Cuts each pixel's interval to the disparities d with 0 <= x - d < width. What is cut off could
/// only hold cells that no disparity map ever takes.
DisparityRange matchable(const DisparityRange& range);

}  // namespace xgm::semi_global
