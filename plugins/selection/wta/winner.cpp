// SPDX-License-Identifier: Apache-2.0
// Winners, a cell at a time: what the kernel's results are measured by.
#include "plugins/selection/wta/winner.hpp"

#include <algorithm>
#include <cstdlib>

namespace xgm::wta {
namespace {

std::uint16_t lowest(const std::uint16_t* cells, int count) {
  std::uint16_t low = kNoMatch;
  for (int i = 0; i < count; ++i) low = std::min(low, cells[i]);
  return low;
}

Ballot count_votes(const std::uint16_t* cells, int count, int best) {
  Ballot ballot{cells[best]};
  for (int i = 0; i < count; ++i) {
    if (cells[i] == kNoMatch) continue;
    ++ballot.matchable;
    ballot.total += cells[i];
    if (std::abs(i - best) > 1) ballot.rival = std::min<std::int64_t>(ballot.rival, cells[i]);
  }
  return ballot;
}

}  // namespace

void select_plain(const std::uint16_t* cells, int count, int begin, int uniqueness, int y, int x,
                  DisparityMap& map) {
  const std::uint16_t low = lowest(cells, count);
  if (low == kNoMatch) {
    map.invalidate(y, x, Status::out_of_range);
    return;
  }
  const auto best = static_cast<int>(std::find(cells, cells + count, low) - cells);
  if (uniqueness > 0 && !clearly_wins(count_votes(cells, count, best), uniqueness)) {
    map.invalidate(y, x, Status::ambiguous);
  } else {
    map.set(y, x, static_cast<float>(begin + best));
  }
}

void select_plain(const AggregatedVolume& sums, int uniqueness, int y, DisparityMap& map) {
  const VolumeShape& shape = sums.shape();
  for (int x = 0; x < shape.width(); ++x) {
    select_plain(sums.at(y, x), shape.count(y, x), shape.begin(y, x), uniqueness, y, x, map);
  }
}

}  // namespace xgm::wta
