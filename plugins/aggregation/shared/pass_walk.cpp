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
  const int slot = lines_.slot(v);
  line.v = v;
  line.penalty_slot = frame_.lines_are_rows() ? slot : -1;
  line.scratch = scratch_[static_cast<std::size_t>(slot)].data();
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    line.back[t] = lines_.line(v - steps_[t].across) - steps_[t].along;
    line.back_costs[t] = lines_.costs(v - steps_[t].across, static_cast<int>(t) / step_.terms);
  }
  for (int path = 0; path < step_.paths; ++path) line.costs[path] = lines_.costs(v, path);
  find_penalties(line, frame_.lines_are_rows() ? cv::Point{0, slot} : cv::Point{v, 0});
  return line;
}

/// `at` is in rows of penalties.
template <class Cell>
void PassWalk<Cell>::find_penalties(Line& line, cv::Point at) const {
  const PixelClasses& base = penalties_.base();
  const int steps = static_cast<int>(steps_.size());
  const std::uint8_t* const classes = base.count() == 1 ? nullptr : base.at(at.y, at.x);
  line.base_classes = base.packed() ? *classes : -1;
  const Cell *p1 = penalties_.p1(), *p2 = penalties_.p2();
  const int row = penalties_.match().count(), table = base.count() * row;
  for (int t = 0; t < steps; ++t, p1 += table, p2 += table) {
    const int offset = classes == nullptr ? 0 : base.get(t, classes) * row;
    line.p1[t] = p1 + offset;
    line.p2[t] = p2 + offset;
  }
}

template <class Cell>
const Cell* PassWalk<Cell>::joined(const WalkedPixel<Cell>& pixel, const Pixel& previous,
                                   const Cell* costs, Cell* scratch) {
  Cell* const first = scratch + kGranule;
  std::fill(first - kGranule, first + pixel.room + kGranule, kInfinite<Cell>);
  if (!previous.counts()) return first;
  // Whole granules: behind the last one there are infinite costs, too.
  const int begin = previous.from + kGranule, end = previous.to + 1 - kGranule;
  for (int d = std::max(begin, pixel.begin - 1); d < std::min(end, pixel.begin + pixel.room + 1);
       d += kGranule)
    std::copy_n(costs + (previous.zero + d), kGranule, first + (d - pixel.begin));
  return first;
}

template class PassWalk<std::uint8_t>;
template class PassWalk<std::uint16_t>;

}  // namespace xgm::aggregation
