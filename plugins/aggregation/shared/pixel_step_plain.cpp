// SPDX-License-Identifier: Apache-2.0
// The inner step, cell by cell.
#include <algorithm>

#include "plugins/aggregation/shared/advance.hpp"

namespace xgm::aggregation {
namespace {

template <class Cell>
int match_class_of(const PassStep& pass, const WalkedPixel<Cell>& pixel, int step, int i) {
  if (pass.match_classes == 1) return 0;
  return pass.class_plane == 0 ? pixel.classes[i] >> step & 1
                               : pixel.classes[step * pass.class_plane + i];
}

template <class Cell>
int brought_by(const PassStep& pass, const WalkedPixel<Cell>& pixel, const Term<Cell>& term,
               int i) {
  const int match_class = match_class_of(pass, pixel, term.step, i);
  const StepPenalties<Cell>& penalties = term.penalties[match_class];
  const int same = term.previous[i];
  const int beside = std::min(term.previous[i - 1], term.previous[i + 1]);
  const int far = *term.least + penalties.p2;
  return std::min({same, beside + penalties.p1, far}) - *term.least;
}

/// Of a path.
template <class Cell>
int brought_by(const PassStep& pass, const WalkedPixel<Cell>& pixel, const Term<Cell>* terms,
               int i) {
  const int first = brought_by(pass, pixel, terms[0], i);
  if (pass.terms == 1) return first;
  const int twice = first + brought_by(pass, pixel, terms[1], i);
  const int down = twice / 2;
  return down + (twice & down & 1);
}

}  // namespace

template <class Cell>
void lower(Cell* costs, int room, Cell& least) {
  for (int i = 0; i < room; ++i) {
    if (costs[i] != kInfinite<Cell>) costs[i] = static_cast<Cell>(costs[i] - least);
  }
  least = 0;
}

template <class Cell>
void extend_plain(const PassWalk<Cell>& walk, const WalkedLine<Cell>& line,
                  const WalkedPixel<Cell>& pixel) {
  const PassStep& pass = walk.step();
  Term<Cell> terms[kMostSteps];
  walk.find_terms(line, pixel.u, pixel.begin, pixel.room, 0, pass.paths, terms);
  const auto costs = [&](int path) { return line.costs[path] + pixel.first; };
  Cell* const least = pixel.least;
  std::fill_n(least, pass.paths, kInfinite<Cell>);
  for (int i = 0; i < pixel.room; ++i) {
    const bool matchable = i < pixel.count && pixel.cost[i] != CostVolume::kNoMatch;
    int sum = 0;
    for (int k = 0; k < pass.paths; ++k) {
      const int brought = brought_by(pass, pixel, terms + k * pass.terms, i);
      const int cost = matchable ? (pixel.cost[i] << pass.bits) + brought : kInfinite<Cell>;
      costs(k)[i] = static_cast<Cell>(cost);
      least[k] = std::min(least[k], static_cast<Cell>(cost));
      sum += brought;
    }
    sum += pass.first ? (pass.cost_weight * pixel.cost[i]) << pass.bits : pixel.sums[i];
    pixel.sums[i] = matchable ? static_cast<std::uint16_t>(sum) : AggregatedVolume::kNoMatch;
  }
  for (int k = 0; k < pass.paths; ++k) {
    if (!has_room_for_p2(least[k], pass)) lower(costs(k), pixel.room, least[k]);
    std::fill_n(costs(k) + pixel.room, VolumeShape::kGranule, kInfinite<Cell>);
  }
}

template void lower(std::uint8_t*, int, std::uint8_t&);
template void lower(std::uint16_t*, int, std::uint16_t&);
template void extend_plain(const PassWalk<std::uint8_t>&, const WalkedLine<std::uint8_t>&,
                           const WalkedPixel<std::uint8_t>&);
template void extend_plain(const PassWalk<std::uint16_t>&, const WalkedLine<std::uint16_t>&,
                           const WalkedPixel<std::uint16_t>&);

}  // namespace xgm::aggregation
