// SPDX-License-Identifier: Apache-2.0
// What three-point sub-pixel fits share: finding S(d-1), S(d), S(d+1) and moving the disparity.
#pragma once

#include <algorithm>
#include <vector>

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

/// The cell of a whole disparity that has one on either side; null for any other, and for none.
inline const std::uint16_t* inner_cell(const AggregatedVolume& sums, int y, int x,
                                       float disparity) {
  const VolumeShape& shape = sums.shape();
  const int begin = shape.begin(y, x);
  // Compared as floats: the cast is safe only for disparities inside the range. NaN is in none.
  if (!(disparity > static_cast<float>(begin)) ||
      !(disparity < static_cast<float>(shape.end(y, x) - 1))) {
    return nullptr;
  }
  const int whole = static_cast<int>(disparity);
  return static_cast<float>(whole) == disparity ? sums.at(y, x) + (whole - begin) : nullptr;
}

/// Looks up the rises around a cell. False where no fit is possible: there is no cell, it or a
/// neighbour is kNoMatch, it is no minimum, or flat.
inline bool find_rises(const std::uint16_t* cell, Rises& rises) {
  constexpr auto kNoMatch = AggregatedVolume::kNoMatch;
  if (cell == nullptr) return false;
  if (cell[-1] == kNoMatch || cell[0] == kNoMatch || cell[1] == kNoMatch) return false;
  rises = {cell[-1] - cell[0], cell[1] - cell[0]};
  return rises.below >= 0 && rises.above >= 0 && rises.below + rises.above > 0;
}

/// Adds shift(rises), within [-0.5, 0.5], to every disparity that allows a fit; all else stays.
template <class Shift>
DisparityMap refine(const DisparityMap& map, const AggregatedVolume& sums, Shift shift) {
  const cv::Size size = map.size();
  DisparityMap refined;
  refined.disparity.create(size);
  refined.status.create(size);
  parallel_for(0, size.height, [&](int y) {
    std::copy_n(map.status[y], size.width, refined.status[y]);
    const float* const whole = map.disparity[y];
    float* const result = refined.disparity[y];
    // Cells of neighbours lie too far apart for the processor to see them coming.
    std::vector<const std::uint16_t*> cells(static_cast<std::size_t>(size.width));
    for (int x = 0; x < size.width; ++x) {
      cells[static_cast<std::size_t>(x)] = inner_cell(sums, y, x, whole[x]);
      __builtin_prefetch(cells[static_cast<std::size_t>(x)]);
    }
    for (int x = 0; x < size.width; ++x) {
      Rises rises;
      const bool fits = find_rises(cells[static_cast<std::size_t>(x)], rises);
      result[x] = fits ? whole[x] + shift(rises) : whole[x];
    }
  });
  return refined;
}

}  // namespace xgm::three_point
