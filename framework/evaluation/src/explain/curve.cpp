// SPDX-License-Identifier: Apache-2.0
#include "explain/curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace xgm::explain {
namespace {

/// Makes room for the disparities of `cells`.
void widen(MatchExplanation& match, Interval cells) {
  if (cells.empty()) return;
  const Interval old = match.range;
  if (old.empty()) {
    match.range = cells;
  } else {
    match.range = {std::min(old.begin, cells.begin), std::max(old.end, cells.end)};
  }
  if (match.range == old) return;
  for (auto* curve : {&match.costs, &match.sums}) {
    if (curve->empty()) continue;
    std::vector<float> wider(static_cast<std::size_t>(match.range.size()), kUnknown);
    std::copy(curve->begin(), curve->end(), wider.begin() + (old.begin - match.range.begin));
    *curve = std::move(wider);
  }
}

/// A cell's number, infinite where nothing matches and beyond the ends.
float height(const std::vector<float>& curve, int i) {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  if (i < 0 || i >= static_cast<int>(curve.size())) return kNone;
  const float value = curve[static_cast<std::size_t>(i)];
  return std::isnan(value) ? kNone : value;
}

float value_at(const std::vector<float>& curve, Interval range, int disparity) {
  if (curve.empty() || !range.contains(disparity)) return kUnknown;
  return curve[static_cast<std::size_t>(disparity - range.begin)];
}

}  // namespace

template <class Cell>
void take_cells(const Volume<Cell>& volume, float units_per_cost, MatchExplanation& match,
                std::vector<float> MatchExplanation::*curve) {
  const int y = match.pixel.y, x = match.pixel.x;
  const VolumeShape& shape = volume.shape();
  widen(match, {shape.begin(y, x), shape.end(y, x)});
  (match.*curve).assign(static_cast<std::size_t>(match.range.size()), kUnknown);
  const Cell* cells = volume.at(y, x);
  for (int d = shape.begin(y, x); d < shape.end(y, x); ++d, ++cells) {
    if (*cells == volume.kNoMatch) continue;
    (match.*curve)[static_cast<std::size_t>(d - match.range.begin)] =
        static_cast<float>(*cells) / units_per_cost;
  }
}

template void take_cells(const Volume<std::uint8_t>&, float, MatchExplanation&,
                         std::vector<float> MatchExplanation::*);
template void take_cells(const Volume<std::uint16_t>&, float, MatchExplanation&,
                         std::vector<float> MatchExplanation::*);

const std::vector<float>& decisive(const MatchExplanation& match) {
  return match.sums.empty() ? match.costs : match.sums;
}

int lowest(const std::vector<float>& curve) {
  int best = -1;
  for (int i = 0; i < static_cast<int>(curve.size()); ++i) {
    if (height(curve, i) < height(curve, best)) best = i;  // that of -1 is infinite
  }
  return best;
}

int runner_up(const std::vector<float>& curve, int winner) {
  const int count = static_cast<int>(curve.size());
  int best = -1;
  for (int first = 0, next = 0; first < count; first = next) {
    next = first + 1;
    while (next < count && height(curve, next) == height(curve, first)) ++next;
    const float here = height(curve, first);
    const bool bottom = here < height(curve, first - 1) && here < height(curve, next);
    const bool winners = first <= winner + 1 && winner - 1 < next && winner >= 0;
    if (bottom && !winners && here < height(curve, best)) best = first;
  }
  return best;
}

Candidate candidate(const MatchExplanation& match, int disparity) {
  return {disparity, value_at(match.costs, match.range, disparity),
          value_at(match.sums, match.range, disparity)};
}

void find_candidates(MatchExplanation& match) {
  const std::vector<float>& curve = decisive(match);
  const int best = lowest(curve);
  if (!match.winner && best >= 0) match.winner = Candidate{match.range.begin + best};
  if (!match.winner) return;
  match.winner = candidate(match, match.winner->disparity);
  const int second = runner_up(curve, match.winner->disparity - match.range.begin);
  if (second >= 0) match.runner_up = candidate(match, match.range.begin + second);
}

}  // namespace xgm::explain
