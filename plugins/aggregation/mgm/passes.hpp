// SPDX-License-Identifier: Apache-2.0
// The paths of MGM in two passes; the opposite passes have the rest.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "plugins/aggregation/path_engine/pass.hpp"

namespace xgm::mgm {

/// A quarter of the directions: an axis, a diagonal, two knight's moves. For these, both p - r and
/// p - r-perp are visited before p in a pass down the rows, from left to right. The other quarters
/// and their passes are the same turned by multiples of 90 degrees.
inline constexpr std::array<Direction, 4> kQuarter{{{0, 1}, {-1, 1}, {-2, 1}, {-1, 2}}};

static_assert(std::ranges::all_of(kQuarter, [](Direction r) {
  return aggregation::comes_earlier(r, {1, 0}, {0, 1}) &&
         aggregation::comes_earlier(aggregation::anticlockwise(r), {1, 0}, {0, 1});
}));

/// One pass down the rows and one over the columns to the right. The opposite passes go up the
/// rows, and over the columns to the left. `directions`: 4, 8 or 16.
inline std::vector<aggregation::Pass> passes(int directions) {
  std::vector<aggregation::Pass> all;
  std::array<Direction, 4> quarter = kQuarter;
  Direction along{1, 0}, across{0, 1};
  for (int turn = 0; turn < 2; ++turn) {
    aggregation::Pass& pass = all.emplace_back(aggregation::Pass{along, across, {}});
    for (int i = 0; i < directions / 4; ++i) {
      const Direction r = quarter[static_cast<std::size_t>(i)];
      pass.paths.push_back({{r, aggregation::anticlockwise(r)}});
    }
    std::ranges::transform(quarter, quarter.begin(), aggregation::anticlockwise);
    along = aggregation::anticlockwise(along);
    across = aggregation::anticlockwise(across);
  }
  return all;
}

}  // namespace xgm::mgm
