// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/path_engine/pass_walk.hpp"

#include <algorithm>

#include "xgm/base/parallel.hpp"

namespace xgm::aggregation {
namespace {

/// The steps of all paths, path by path.
std::vector<Direction> all_steps(const Pass& pass) {
  std::vector<Direction> steps;
  for (const Path& path : pass.paths)
    steps.insert(steps.end(), path.steps.begin(), path.steps.end());
  return steps;
}

/// Number of pixels that line v - 1 must be ahead of line v.
int find_lag(const Pass& pass) {
  int lag = 0;
  for (const Direction x : all_steps(pass)) {
    const int along = pixels_along(x, pass.along), across = lines_across(x, pass.across);
    if (across > 0) lag = std::max(lag, (-along + across - 1) / across);
  }
  return lag;
}

}  // namespace

/// When a band is begun, all bands before it are finished, except those that other threads of the
/// same direction are working on. While a line is at pixel u, the lines that read its path costs
/// are at pixel u - 2 * lag or earlier. One more pixel is kept because the granule behind a slice
/// overwrites the cells that follow.
LinesKept lines_kept(const Pass& pass, int lines, int threads) {
  int looked_back = 0;
  for (const Direction x : all_steps(pass))
    looked_back = std::max(looked_back, lines_across(x, pass.across));
  return {.bands = std::min(threads / 2 + 2, bands_of(lines)),
          .band_lines = kBand,
          .last_lines = looked_back,
          .pixels = 2 * find_lag(pass) + 2 * kFarthest + 2};
}

template <class Cell>
PassWalk<Cell>::PassWalk(const CostVolume& costs, const PenaltyField& penalties, const Pass& pass,
                         const PathLayout& layout, PassStep step, AggregatedVolume& sums,
                         int first_line)
    : costs_(costs),
      shape_(costs.shape()),
      sums_(sums),
      step_(step),
      frame_(shape_.size(), pass.along, pass.across, first_line),
      lag_(find_lag(pass)),
      lines_(layout, frame_, static_cast<int>(pass.paths.size()),
             lines_kept(pass, frame_.lines(), thread_count())),
      penalties_(penalties, all_steps(pass),
                 frame_.lines_are_rows() ? lines_.slots() : shape_.height(), shape_.width(),
                 shape_.hull(), 1 << step.bits),
      // A slice, a granule before it, and the cells that vectors of up to 64 read behind it.
      scratch_stride_(VolumeShape::rounded_up(shape_.max_count()) + 6 * kGranule) {
  for (const Direction x : all_steps(pass))
    steps_.push_back({pixels_along(x, pass.along), lines_across(x, pass.across)});
  step_.paths = static_cast<int>(pass.paths.size());
  step_.terms = static_cast<int>(pass.paths.front().steps.size());
  step_.match_classes = penalties_.match().count();
  if (step_.match_classes > 1 && !penalties_.match().packed())
    step_.class_plane = penalties_.match().plane_stride();
  scratch_.assign(static_cast<std::size_t>(lines_.slots()),
                  std::vector<Cell>(static_cast<std::size_t>(scratch_stride_) * steps_.size()));
  looked_up_.assign(scratch_.size(), std::vector<StepPenalties>(penalties_.row_size()));
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
void PassWalk<Cell>::begin_line(int v, bool begins_sums, Line& line) {
  const cv::Point start = frame_.pixel(0, v);
  const Direction along = frame_.along();
  line.v = v;
  line.begins_sums = begins_sums;
  line.start = start;
  line.slices = {&shape_.slice(start.y, start.x),
                 along.dx + std::ptrdiff_t{along.dy} * shape_.width()};
  const int slot = lines_.slot(v), row = frame_.lines_are_rows() ? slot : start.y;
  const PixelClasses &base = penalties_.base(), &match = penalties_.match();
  line.base_classes = {};
  if (base.count() > 1)
    line.base_classes = {base.at(row, start.x), along.dx + along.dy * base.row_stride()};
  line.match_classes = {};
  if (match.count() > 1)
    line.match_classes = {penalties_.match_at(row, start.x),
                          along.dy * match.row_stride() - along.dx};
  line.scratch = scratch_[static_cast<std::size_t>(slot)].data();
  line.looked_up = looked_up_[static_cast<std::size_t>(slot)].data();
  line.pixels = lines_.pixels(v);
  for (int i = 0; i <= kFarthest; ++i) line.any_lost[i] = lines_.pixels(v - i).any_lost;
  for (std::size_t t = 0; t < steps_.size(); ++t) {
    line.back[t] = lines_.pixels(v - steps_[t].across).at(-steps_[t].along);
    line.back_costs[t] = lines_.costs(v - steps_[t].across, static_cast<int>(t) / step_.terms);
  }
  for (int path = 0; path < step_.paths; ++path) line.costs[path] = lines_.costs(v, path);
}

template <class Cell>
bool PassWalk<Cell>::lay_out(Line& line, int first, int last) {
  LineLayout& layout = line.layout;
  layout.first = first;
  const int from = std::clamp(-first, 0, last - first);
  const int to = std::clamp(frame_.length() - first, from, last - first);
  std::fill(layout.room, layout.room + from, 0);
  std::fill(layout.room + to, layout.room + LineLayout::kPixels, 0);
  if (from == to) return false;
  const int dy = frame_.along().dy;
  const Strided<VolumeShape::Slice> slices = line.slices;
  for (int k = from; k < to; ++k) {
    // The address may lie beyond the image; prefetching it is harmless.
    __builtin_prefetch(slices.at(first + k + LineLayout::kPixels));
    const VolumeShape::Slice slice = *slices.at(first + k);
    layout.begin[k] = slice.begin;
    layout.count[k] = slice.count;
    layout.room[k] = VolumeShape::rounded_up(slice.count);
    layout.offset[k] = shape_.offset(line.start.y + (first + k) * dy, slice);
  }
  for (int k = to; k < to + LineLayout::kAhead; ++k)
    layout.offset[k] = offset_of(line, std::min(first + k, frame_.length() - 1));
  lines_.open(line.v, layout, from, to);
  plan_classes(line, from, to);
  return true;
}

template <class Cell>
void PassWalk<Cell>::plan_classes(Line& line, int from, int to) const {
  int* const classes_of_pixels = line.layout.base_classes;
  const PixelClasses& base = penalties_.base();
  if (base.count() == 1 || !base.packed()) {
    std::fill(classes_of_pixels + from, classes_of_pixels + to,
              base.count() == 1 ? 0 : LineLayout::kUnknown);
    return;
  }
  const Strided<std::uint8_t> classes = line.base_classes;
  for (int k = from; k < to; ++k) {
    __builtin_prefetch(classes.at(line.layout.first + k + LineLayout::kPixels));
    classes_of_pixels[k] = *classes.at(line.layout.first + k);
  }
}

template <class Cell>
void PassWalk<Cell>::look_up_penalties(Line& line, int k) const {
  penalties_.look_up(line.base_classes.at(line.layout.first + k), line.looked_up);
  line.penalties = line.looked_up;
}

template <class Cell>
const Term<Cell>* PassWalk<Cell>::find_terms(Line& line, int k) const {
  const int u = line.layout.first + k, begin = line.layout.begin[k], room = line.layout.room[k];
  for (int t = 0; t < static_cast<int>(steps_.size()); ++t) {
    int step = t;
    if (step_.terms == 2 && line.back[t].lost[u]) {
      const int other = t ^ 1;
      if (!line.back[other].lost[u]) step = other;
    }
    const Pixels previous = line.back[step].at(u);
    const Cell* const costs = line.back_costs[step];
    const bool holds = begin - 1 >= *previous.from && begin + room <= *previous.to;
    const Cell* const cells = holds ? costs + (*previous.zero + begin)
                                    : joined(begin, room, previous, costs,
                                             line.scratch + std::ptrdiff_t{scratch_stride_} * step);
    line.terms[t] = {cells, previous.minimum + t / step_.terms, step,
                     line.penalties + step * step_.match_classes};
  }
  return line.terms;
}

template <class Cell>
const Cell* PassWalk<Cell>::joined(int begin, int room, const Pixels& previous, const Cell* costs,
                                   Cell* scratch) {
  Cell* const first = scratch + kGranule;
  std::fill(first - kGranule, first + room + kGranule, kInfinite<Cell>);
  // Copies whole granules; the cells behind the count in the last one are infinite as well. Copies
  // nothing from a previous pixel that does not exist.
  const int from = *previous.from + kGranule, to = *previous.to + 1 - kGranule;
  for (int d = std::max(from, begin - 1); d < std::min(to, begin + room + 1); d += kGranule)
    std::copy_n(costs + (*previous.zero + d), kGranule, first + (d - begin));
  return first;
}

template class PassWalk<std::uint8_t>;
template class PassWalk<std::uint16_t>;

}  // namespace xgm::aggregation
