// SPDX-License-Identifier: Apache-2.0
// What the costs that compare pixel with pixel share: which candidates a base pixel has.
#pragma once

#include <algorithm>
#include <cstdint>

#include "xgm/data/image.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::cost {

/// The candidates of base pixel x that lie inside the match image, by ascending disparity.
/// Ascending disparity walks the match row backwards; so match rows are stored mirrored (element i
/// belongs to match pixel width - 1 - i), and the candidate of cells[i] is element first + i.
struct Candidates {
  int x = 0;
  int first = 0;
  int count = 0;
  std::uint8_t* cells = nullptr;
};

/// Fills row y of the volume: fill(Candidates) is called for each base pixel that has candidates
/// and writes all their cells; cells outside the match image, or masked there, become kNoMatch.
template <class Fill>
void fill_row(CostVolume& costs, const cv::Mat1b& match_valid, int y, Fill fill) {
  const VolumeShape& shape = costs.shape();
  const int width = shape.width();
  for (int x = 0; x < width; ++x) {
    const Interval range{shape.begin(y, x), shape.end(y, x)};
    const Interval inside = intersect(range, {x - width + 1, x + 1});
    std::uint8_t* const cells = costs.at(y, x);
    if (inside.empty()) {
      std::fill_n(cells, range.size(), CostVolume::kNoMatch);
      continue;
    }
    std::uint8_t* const first = cells + (inside.begin - range.begin);
    std::fill(cells, first, CostVolume::kNoMatch);
    fill(Candidates{x, width - 1 - x + inside.begin, inside.size(), first});
    std::fill(first + inside.size(), cells + range.size(), CostVolume::kNoMatch);
    if (match_valid.empty()) continue;
    for (int i = 0; i < inside.size(); ++i) {
      if (match_valid(y, x - inside.begin - i) == 0) first[i] = CostVolume::kNoMatch;
    }
  }
}

/// The pair with as many planes in one view as in the other: as it is, or both as grey images.
inline ImagePair comparable(const ImagePair& pair) {
  ImagePair result = pair;
  if (pair.base.planes.size() != pair.match.planes.size()) {
    result.base.planes = {pair.base.grey()};
    result.match.planes = {pair.match.grey()};
  }
  return result;
}

}  // namespace xgm::cost
