// SPDX-License-Identifier: Apache-2.0
// A pair that is matched in a second or two, to see what one of any size takes.
#pragma once

#include "xgm/data/pair_windows.hpp"

namespace xgm::tiles {

struct SmallPair {
  ImagePair pair;
  int scale = 1;  ///< how many times smaller its pixels are
};

/// Of large images two bands: in much smaller images every disparity is near any pixel, and all
/// would be searched. Of their whole only where the bands have hardly any data.
SmallPair small_pair(const PairWindows& pair);

}  // namespace xgm::tiles
