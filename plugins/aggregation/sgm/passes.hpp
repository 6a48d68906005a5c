// SPDX-License-Identifier: Apache-2.0
// The paths of SGM in a pass down the rows; the opposite pass has the rest.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "plugins/aggregation/path_engine/pass.hpp"

namespace xgm::sgm {

/// The directions r for which p - r precedes p in row-major order: axes, then diagonals, then
/// knight's moves. The other half are their negatives.
inline constexpr std::array<Direction, 8> kForward{
    {{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {1, 2}, {2, 1}, {-1, 2}, {-2, 1}}};

static_assert(std::ranges::all_of(kForward, [](Direction r) {
  return aggregation::comes_earlier(r, {1, 0}, {0, 1});
}));

/// Down the rows, from left to right; the opposite goes up, from right to left. `directions`: 4, 8
/// or 16.
inline std::vector<aggregation::Pass> passes(int directions) {
  aggregation::Pass forward{{1, 0}, {0, 1}, {}};
  for (int i = 0; i < directions / 2; ++i)
    forward.paths.push_back({{kForward[static_cast<std::size_t>(i)]}});
  return {forward};
}

}  // namespace xgm::sgm
