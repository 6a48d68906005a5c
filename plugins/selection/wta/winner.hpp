// SPDX-License-Identifier: Apache-2.0
// Which cell of a pixel wins, and whether it wins clearly.
#pragma once

#include <cstdint>

#include "xgm/data/disparity_map.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::wta {

inline constexpr std::uint16_t kNoMatch = AggregatedVolume::kNoMatch;

/// The cells of one pixel: what the decision rests on.
struct Ballot {
  std::int64_t low = kNoMatch;    ///< the lowest sum
  std::int64_t rival = kNoMatch;  ///< the lowest one not next to it
  std::int64_t matchable = 0;     ///< how many cells can match
  std::int64_t total = 0;         ///< sum of the cells that can match
};

/// Is every rival (a matchable cell that is not the best or next to it) above the best by more than
/// `percent` of the pixel's contrast, the mean of its matchable sums less the lowest? In whole
/// numbers: (rival - low) * n * 100 > percent * (total - n * low).
inline bool clearly_wins(const Ballot& b, int percent) {
  return b.rival == kNoMatch ||
         (b.rival - b.low) * b.matchable * 100 > percent * (b.total - b.matchable * b.low);
}

/// Sets row y of the map: the disparity of the lowest sum, of equal ones the smallest disparity;
/// out_of_range where no cell can match; ambiguous where `uniqueness` (%; 0 asks for nothing) is
/// more than clearly_wins() grants.
void select(const AggregatedVolume& sums, int uniqueness, int y, DisparityMap& map);

/// The same without vector instructions.
void select_plain(const AggregatedVolume& sums, int uniqueness, int y, DisparityMap& map);

/// Of one pixel, the `count` cells of which begin with disparity `begin`.
void select_plain(const std::uint16_t* cells, int count, int begin, int uniqueness, int y, int x,
                  DisparityMap& map);

}  // namespace xgm::wta
