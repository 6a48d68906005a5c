// SPDX-License-Identifier: Apache-2.0
// Fills a cost volume candidate by candidate.
#pragma once

#include "xgm/base/parallel.hpp"
#include "xgm/data/image.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::exchange {

/// cost(y, x, d) of each cell whose candidate has data; kNoMatch of the others.
template <class Cost>
void for_each_candidate(const ImagePair& pair, CostVolume& costs, const Cost& cost) {
  const VolumeShape& shape = costs.shape();
  parallel_for(0, shape.height(), [&](int y) {
    for (int x = 0; x < shape.width(); ++x) {
      std::uint8_t* cell = costs.at(y, x);
      for (int d = shape.begin(y, x); d < shape.end(y, x); ++d, ++cell) {
        const bool seen = x - d >= 0 && x - d < shape.width() && pair.match.is_valid(y, x - d);
        *cell = seen ? cost(y, x, d) : CostVolume::kNoMatch;
      }
    }
  });
}

}  // namespace xgm::exchange
