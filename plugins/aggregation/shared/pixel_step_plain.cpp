// SPDX-License-Identifier: Apache-2.0
// The inner step, cell by cell.
#include <algorithm>

#include "plugins/aggregation/shared/pixel_step.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::aggregation {
namespace {

template <class Cell>
int brought_by(const Term<Cell>& term, int match_classes, int i) {
  const int match_class = match_classes > 1 ? term.classes[i] : 0;
  const int same = term.previous[i];
  const int beside = std::min(term.previous[i - 1], term.previous[i + 1]);
  return std::min({same, beside + term.p1[match_class], int{term.p2[match_class]}});
}

template <class Cell>
int brought_by(const PassStep& pass, const Extension<Cell>& path, int i) {
  const int first = brought_by(path.terms[0], pass.match_classes, i);
  if (pass.terms == 1) return first;
  const int twice = first + brought_by(path.terms[1], pass.match_classes, i);
  const int down = twice / 2;
  return down + (twice & down & 1);
}

}  // namespace

template <class Cell>
bool extend_paths_plain(const PassStep& pass, const PixelStep<Cell>& pixel) {
  int least[kMostPaths];
  std::fill_n(least, pass.paths, int{kInfinite<Cell>});
  for (int i = 0; i < pixel.room; ++i) {
    const bool matchable = i < pixel.count && pixel.cost[i] != CostVolume::kNoMatch;
    int sum = 0;
    for (int k = 0; k < pass.paths; ++k) {
      const int brought = brought_by(pass, pixel.paths[k], i);
      const int cost = matchable ? (pixel.cost[i] << pass.bits) + brought : kInfinite<Cell>;
      pixel.paths[k].costs[i] = static_cast<Cell>(cost);
      least[k] = std::min(least[k], cost);
      sum += brought;
    }
    sum += pass.first ? (pass.cost_weight * pixel.cost[i]) << pass.bits : pixel.sums[i];
    pixel.sums[i] = matchable ? static_cast<std::uint16_t>(sum) : AggregatedVolume::kNoMatch;
  }
  for (int k = 0; k < pass.paths; ++k) {
    Cell* const costs = pixel.paths[k].costs;
    for (int i = 0; i < pixel.room; ++i) {
      if (costs[i] != kInfinite<Cell>) costs[i] = static_cast<Cell>(costs[i] - least[k]);
    }
    std::fill_n(costs + pixel.room, VolumeShape::kGranule, kInfinite<Cell>);
  }
  return least[0] != kInfinite<Cell>;
}

template bool extend_paths_plain(const PassStep&, const PixelStep<std::uint8_t>&);
template bool extend_paths_plain(const PassStep&, const PixelStep<std::uint16_t>&);

}  // namespace xgm::aggregation
