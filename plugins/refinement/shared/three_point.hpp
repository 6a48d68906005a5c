// SPDX-License-Identifier: Apache-2.0
// What three-point sub-pixel fits share: finding S(d-1), S(d), S(d+1) and moving the disparity.
#pragma once

#include <cmath>

#include "xgm/base/parallel.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::three_point {

/// How much the sum rises from the disparity to its neighbours: S(d-1) - S(d) and S(d+1) - S(d).
/// Rises, unlike sums, do not depend on the constant that each pixel's sums may carry.
struct Rises {
  int below = 0;
  int above = 0;
};

/// Looks up the rises at `disparity`. False where no fit is possible: the disparity is no whole
/// number, it or a neighbour is outside the pixel's range or kNoMatch, it is no minimum, or flat.
inline bool find_rises(const AggregatedVolume& sums, int y, int x, float disparity, Rises& rises) {
  const float whole = std::nearbyint(disparity);
  const VolumeShape& shape = sums.shape();
  // Compared as floats: the cast is safe only for disparities inside the range.
  if (whole != disparity || !(whole > static_cast<float>(shape.begin(y, x))) ||
      !(whole < static_cast<float>(shape.end(y, x) - 1))) {
    return false;
  }
  const std::uint16_t* cell = sums.at(y, x) + (static_cast<int>(whole) - shape.begin(y, x));
  constexpr auto kNoMatch = AggregatedVolume::kNoMatch;
  if (cell[-1] == kNoMatch || cell[0] == kNoMatch || cell[1] == kNoMatch) return false;
  rises = {cell[-1] - cell[0], cell[1] - cell[0]};
  return rises.below >= 0 && rises.above >= 0 && rises.below + rises.above > 0;
}

/// Adds shift(rises), within [-0.5, 0.5], to every disparity that allows a fit; all else stays.
template <class Shift>
DisparityMap refine(const DisparityMap& map, const AggregatedVolume& sums, Shift shift) {
  DisparityMap refined = map.clone();
  parallel_for(0, map.size().height, [&](int y) {
    Rises rises;
    for (int x = 0; x < map.size().width; ++x) {
      if (map.valid(y, x) && find_rises(sums, y, x, map.disparity(y, x), rises)) {
        refined.disparity(y, x) += shift(rises);
      }
    }
  });
  return refined;
}

}  // namespace xgm::three_point
