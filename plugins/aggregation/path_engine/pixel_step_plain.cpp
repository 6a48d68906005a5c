// SPDX-License-Identifier: Apache-2.0
// The inner step in scalar code, cell by cell: the reference for the vector kernels.
#include <algorithm>

#include "plugins/aggregation/path_engine/advance.hpp"

namespace xgm::aggregation {
namespace {

/// What is fixed for all disparities of a pixel.
template <class Cell>
struct Pixel {
  const PassStep& pass;
  const Term<Cell>* terms;
  const std::uint8_t* classes;  ///< match classes of the disparities

  int match_class(int step, int i) const {
    if (pass.match_classes == 1) return 0;
    return pass.class_plane == 0 ? classes[i] >> step & 1 : classes[step * pass.class_plane + i];
  }

  int message_of(const Term<Cell>& term, int i) const {
    const StepPenalties& penalties = term.penalties[match_class(term.step, i)];
    const int minimum = term.minimum->template as<Cell>();
    const int same = term.previous[i];
    const int beside = std::min(term.previous[i - 1], term.previous[i + 1]);
    const int far = minimum + penalties.p2.template as<Cell>();
    return std::min({same, beside + penalties.p1.template as<Cell>(), far}) - minimum;
  }

  int message_of_path(int path, int i) const {
    const int first = message_of(terms[path * pass.terms], i);
    if (pass.terms == 1) return first;
    const int twice = first + message_of(terms[path * pass.terms + 1], i);
    const int down = twice / 2;
    return down + (twice & down & 1);
  }
};

}  // namespace

template <class Cell>
void lower(Cell* costs, int room, Cell minimum) {
  for (int i = 0; i < room; ++i) {
    if (costs[i] != kInfinite<Cell>) costs[i] = static_cast<Cell>(costs[i] - minimum);
  }
}

template <class Cell>
void extend_plain(const PassWalk<Cell>& walk, WalkedLine<Cell>& line, int k) {
  const PassStep& pass = walk.step();
  const LineLayout& layout = line.layout;
  const int u = layout.first + k, room = layout.room[k];
  walk.find_penalties(line, k);
  const Pixel<Cell> pixel{pass, walk.find_terms(line, k),
                          walk.match_classes(line, u, layout.begin[k])};
  const std::uint8_t* const cost = walk.costs() + layout.offset[k];
  std::uint16_t* const sums = walk.sums() + layout.offset[k];
  const auto costs = [&](int path) { return line.costs[path] + layout.own[k]; };
  Cell minimum[kMaxPaths];
  std::fill_n(minimum, kMaxPaths, kInfinite<Cell>);
  for (int i = 0; i < room; ++i) {
    const bool matchable = i < layout.count[k] && cost[i] != CostVolume::kNoMatch;
    int sum = 0;
    for (int path = 0; path < pass.paths; ++path) {
      const int message = pixel.message_of_path(path, i);
      const int extended = matchable ? (cost[i] << pass.bits) + message : kInfinite<Cell>;
      costs(path)[i] = static_cast<Cell>(extended);
      minimum[path] = std::min(minimum[path], static_cast<Cell>(extended));
      sum += message;
    }
    sum += line.begins_sums ? (pass.cost_weight * cost[i]) << pass.bits : sums[i];
    sums[i] = matchable ? static_cast<std::uint16_t>(sum) : AggregatedVolume::kNoMatch;
  }
  if (minimum[0] == kInfinite<Cell>) line.pixels.lose(u);
  for (int path = 0; path < pass.paths; ++path) {
    if (!has_room_for_p2(minimum[path], pass)) {
      lower(costs(path), room, minimum[path]);
      minimum[path] = 0;
    }
    line.pixels.minimum[std::ptrdiff_t{u} * pass.paths + path] = Repeated(minimum[path]);
    std::fill_n(costs(path) + room, VolumeShape::kGranule, kInfinite<Cell>);
  }
}

template void lower(std::uint8_t*, int, std::uint8_t);
template void lower(std::uint16_t*, int, std::uint16_t);
template void extend_plain(const PassWalk<std::uint8_t>&, WalkedLine<std::uint8_t>&, int);
template void extend_plain(const PassWalk<std::uint16_t>&, WalkedLine<std::uint16_t>&, int);

}  // namespace xgm::aggregation
