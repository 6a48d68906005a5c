// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/path_engine/parameters.hpp"

namespace xgm::aggregation {

void describe(PathParameters& parameters, ParameterSet& set) {
  set.add("directions", parameters.directions,
          "Number of path directions: 4 (along the axes), 8 (and diagonals) or 16 (and knight's "
          "moves).")
      .one_of({4, 8, 16});
  set.add("overcounting_correction", parameters.overcounting_correction,
          "Whether a matching cost counts once, not once per direction: S - (N - 1) C "
          "(Drory et al., GCPR 2014).");
}

}  // namespace xgm::aggregation
