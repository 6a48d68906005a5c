// SPDX-License-Identifier: Apache-2.0
// What path-wise aggregations take: the sums, and beside them the path costs of the last few lines.
#pragma once

#include <algorithm>

#include "xgm/stage/needs.hpp"

namespace xgm::aggregation {

/// How an aggregation walks.
struct Walk {
  int paths = 8;
  int steps = 1;           ///< of each path: previous pixels that it is extended from
  int passes = 2;          ///< over the volumes
  int bytes_per_cell = 1;  ///< of a path cost
};

inline Needs needs(const Workload& load, const Walk& walk) {
  constexpr int kLinesLookedBack = 2;
  constexpr double kBytesOfPass =
      5;  // reads a cost, reads and writes a sum; the first does not read
  const double longest = std::max(load.size.width, load.size.height);
  const double line = longest * load.cells_per_pixel * walk.paths / walk.passes;
  return {.volumes = 2 * load.cells(),
          .working = (load.threads + kLinesLookedBack) * line * walk.bytes_per_cell,
          .updates = load.cells() * walk.paths * walk.steps,
          .moved = load.cells() * (kBytesOfPass * walk.passes - 2)};
}

}  // namespace xgm::aggregation
