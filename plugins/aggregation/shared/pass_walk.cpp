// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/shared/pass_walk.hpp"

#include <algorithm>

#include "xgm/base/parallel.hpp"

namespace xgm::aggregation {
namespace {

/// Those of the first path, of the second...
std::vector<Direction> all_steps(const Pass& pass) {
  std::vector<Direction> steps;
  for (const Path& path : pass.paths)
    steps.insert(steps.end(), path.steps.begin(), path.steps.end());
  return steps;
}

/// How far line v - 1 must be ahead of line v.
int find_lag(const Pass& pass) {
  int lag = 0;
  for (const Direction x : all_steps(pass)) {
    const int along = pixels_along(x, pass.along), across = lines_across(x, pass.across);
    if (across > 0) lag = std::max(lag, (-along + across - 1) / across);
  }
  return lag;
}

}  // namespace

/// A band is begun when all before it are finished but those that other threads are at. While a
/// line of it is at pixel u, the ones that look back at it are at u - 2 * lag or before.
LinesKept lines_kept(const Pass& pass, int lines, int threads) {
  int looked_back = 0;
  for (const Direction x : all_steps(pass))
    looked_back = std::max(looked_back, lines_across(x, pass.across));
  return {.bands = std::min(threads + 1, (lines + kBand - 1) / kBand),
          .band_lines = kBand,
          .last_lines = looked_back,
          .pixels = 2 * find_lag(pass) + 2 * kFarthest + 1};
}

template <class Cell>
PassWalk<Cell>::PassWalk(const CostVolume& costs, const PenaltyField& penalties, const Pass& pass,
                         const PathLayout& layout, PassStep step, AggregatedVolume& sums)
    : costs_(costs),
      shape_(costs.shape()),
      sums_(sums),
      step_(step),
      frame_(shape_.size(), pass.along, pass.across),
      lag_(find_lag(pass)),
      lines_(layout, frame_, static_cast<int>(pass.paths.size()),
             lines_kept(pass, frame_.lines(), thread_count())),
      penalties_(penalties, all_steps(pass),
                 frame_.lines_are_rows() ? lines_.slots() : shape_.height(), shape_.width(),
                 shape_.hull(), 1 << step.bits),
      // A slice, a granule before it, and what copying whole granules writes behind it.
      scratch_stride_(VolumeShape::rounded_up(shape_.max_count()) + 3 * kGranule) {
  for (const Direction x : all_steps(pass))
    steps_.push_back({pixels_along(x, pass.along), lines_across(x, pass.across)});
  step_.paths = static_cast<int>(pass.paths.size());
  step_.terms = static_cast<int>(pass.paths.front().steps.size());
  step_.match_classes = penalties_.match().count();
  if (step_.match_classes > 1 && !penalties_.match().packed())
    step_.class_plane = penalties_.match().plane_stride();
  scratch_.assign(static_cast<std::size_t>(lines_.slots()),
                  std::vector<Cell>(static_cast<std::size_t>(scratch_stride_) * steps_.size()));
}

template <class Cell>
void PassWalk<Cell>::load_penalties() {
  if (frame_.lines_are_rows()) return;
  parallel_for(0, shape_.height(), [&](int y) { penalties_.load(y, y); });
}

template <class Cell>
void PassWalk<Cell>::load_penalties(int v) {
  if (frame_.lines_are_rows()) penalties_.load(lines_.slot(v), frame_.pixel(0, v).y);
}

template <class Cell>
auto PassWalk<Cell>::begin_line(int v) -> Line {
  Line line;
  const cv::Point start = frame_.pixel(0, v);
  const Direction along = frame_.along();
  line.start = start;
  line.pixels = lines_.line(v);
  line.cells = lines_.cells(v);
  line.slices = {&shape_.slice(start.y, start.x),
                 along.dx + std::ptrdiff_t{along.dy} * shape_.width()};
  const int slot = lines_.slot(v), row = frame_.lines_are_rows() ? slot : start.y;
  const PixelClasses &base = penalties_.base(), &match = penalties_.match();
  if (base.count() > 1)
    line.base_classes = {base.at(row, start.x), along.dx + along.dy * base.row_stride()};
  if (match.count() > 1)
    line.match_classes = {penalties_.match_at(row, start.x),
                          along.dy * match.row_stride() - along.dx};
  line.scratch = scratch_[static_cast<std::size_t>(slot)].data();
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    line.back[t] = lines_.line(v - steps_[t].across) - steps_[t].along;
    line.back_costs[t] = lines_.costs(v - steps_[t].across, static_cast<int>(t) / step_.terms);
  }
  for (int path = 0; path < step_.paths; ++path) line.costs[path] = lines_.costs(v, path);
  find_penalties(line, line.base_classes.first);
  return line;
}

template <class Cell>
void PassWalk<Cell>::find_penalties(Line& line, const std::uint8_t* classes) const {
  const PixelClasses& base = penalties_.base();
  const int steps = static_cast<int>(steps_.size());
  line.known_classes = base.packed() ? *classes : -1;
  const StepPenalties<Cell>* penalties = penalties_.tables();
  const int row = penalties_.match().count(), table = base.count() * row;
  for (int t = 0; t < steps; ++t, penalties += table) {
    const int offset = classes == nullptr ? 0 : base.get(t, classes) * row;
    line.penalties[t] = penalties + offset;
  }
}

template <class Cell>
void PassWalk<Cell>::find_terms(const Line& line, int u, int begin, int room, int first_path,
                                int paths, Term<Cell>* terms) const {
  const int first_step = first_path * step_.terms;
  for (int t = 0; t < paths * step_.terms; ++t) {
    int step = first_step + t;
    if (step_.terms == 2 && !line.back[step][u].counts()) {
      const int other = step ^ 1;
      if (line.back[other][u].counts()) step = other;
    }
    const Pixel& previous = line.back[step][u];
    const Cell* const costs = line.back_costs[step];
    const Cell* const cells = holds(previous, begin, room)
                                  ? costs + previous.zero + begin
                                  : joined(begin, room, previous, costs,
                                           line.scratch + std::ptrdiff_t{scratch_stride_} * step);
    terms[t] = {cells, previous.least + (first_path + t / step_.terms), step, line.penalties[step]};
  }
}

template <class Cell>
const Cell* PassWalk<Cell>::joined(int begin, int room, const Pixel& previous, const Cell* costs,
                                   Cell* scratch) {
  Cell* const first = scratch + kGranule;
  std::fill(first - kGranule, first + room + kGranule, kInfinite<Cell>);
  if (!previous.counts()) return first;
  // Whole granules: behind the last one there are infinite costs, too.
  const int from = previous.from + kGranule, to = previous.to + 1 - kGranule;
  for (int d = std::max(from, begin - 1); d < std::min(to, begin + room + 1); d += kGranule)
    std::copy_n(costs + (previous.zero + d), kGranule, first + (d - begin));
  return first;
}

template class PassWalk<std::uint8_t>;
template class PassWalk<std::uint16_t>;

}  // namespace xgm::aggregation
