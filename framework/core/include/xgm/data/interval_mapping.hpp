// SPDX-License-Identifier: Apache-2.0
// What an interval of disparities becomes at another scale and in the other view.
#pragma once

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"

namespace xgm {

/// In images that are `scale` times smaller: the ends are rounded outwards.
XGM_API Interval divided(Interval interval, double scale);

/// In the other view, where disparities have the opposite sign.
XGM_API Interval reversed(Interval interval);

}  // namespace xgm
