// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/shared/pass_runner.hpp"

#include <algorithm>

#include "xgm/base/parallel.hpp"

namespace xgm::aggregation {
namespace {

// Passes that go backwards or along columns are no pattern that processors foresee.
constexpr int kCellsFetchedAhead = 4, kSlicesFetchedAhead = 24;  // in pixels
constexpr int kGranule = VolumeShape::kGranule;

// Lines that a thread walks along at once, a pixel of each in turn. A path along the line has to
// wait for its least cost at one pixel before the next; meanwhile the other lines advance.
constexpr int kBand = 4;

template <class See>
void for_each_step(const Pass& pass, See see) {
  for (const Path& path : pass.paths) {
    for (const Direction x : path.steps)
      see(pixels_along(x, pass.along), lines_across(x, pass.across));
  }
}

/// How far line v - 1 must be ahead of line v.
int find_lag(const Pass& pass) {
  int lag = 0;
  for_each_step(pass, [&](int along, int across) {
    if (across > 0) lag = std::max(lag, (-along + across - 1) / across);
  });
  return lag;
}

/// A band is begun when all before it are finished but those that other threads are at. While a
/// line of it is at pixel u, the ones that look back at it are at u - 2 * lag or before.
LinesKept lines_kept(const Pass& pass, int lines) {
  int looked_back = 0;
  for_each_step(pass, [&](int, int across) { looked_back = std::max(looked_back, across); });
  const int bands = (lines + kBand - 1) / kBand;
  return {.bands = std::min(thread_count() + 1, bands),
          .band_lines = kBand,
          .last_lines = looked_back,
          .pixels = 2 * find_lag(pass) + 2 * kFarthest + 1};
}

}  // namespace

template <class Cell>
PassRunner<Cell>::PassRunner(const CostVolume& costs, const PenaltyField& penalties,
                             const Pass& pass, const PathLayout& layout, PassStep step,
                             AggregatedVolume& sums)
    : costs_(costs),
      shape_(costs.shape()),
      sums_(sums),
      step_(step),
      frame_(shape_.size(), pass.along, pass.across),
      lag_(find_lag(pass)),
      lines_(layout, frame_, static_cast<int>(pass.paths.size()), lines_kept(pass, frame_.lines())),
      // A slice, a granule before it, and what copying whole granules writes behind it.
      scratch_stride_(VolumeShape::rounded_up(shape_.max_count()) + 3 * kGranule) {
  const int penalty_slots = frame_.lines_are_rows() ? lines_.slots() : shape_.height();
  step_.paths = static_cast<int>(pass.paths.size());
  step_.terms = static_cast<int>(pass.paths.front().steps.size());
  for (const Path& path : pass.paths) {
    for (const Direction x : path.steps) {
      steps_.push_back({pixels_along(x, pass.along), lines_across(x, pass.across),
                        StepPenalties<Cell>(penalties, x, penalty_slots, shape_.width(),
                                            shape_.hull(), 1 << step.bits)});
      step_.match_classes = std::max(step_.match_classes, steps_.back().penalties.match_classes());
      same_penalties_ = same_penalties_ && steps_.back().penalties.same_everywhere();
    }
  }
  const auto stride = static_cast<std::size_t>(scratch_stride_);
  no_classes_.assign(stride, 0);
  scratch_.assign(static_cast<std::size_t>(lines_.slots()),
                  std::vector<Cell>(stride * kMostPaths * kMostTerms));
  extend_ = choose_extend_paths<Cell>(step_);
}

template <class Cell>
void PassRunner<Cell>::run(LineProgress& progress) {
  ExceptionKeeper keeper;
  // Rows of penalty classes are asked for row by row. A pass along columns crosses all rows with
  // each line, so that it needs them all beforehand.
  if (!frame_.lines_are_rows())
    parallel_for(0, shape_.height(), [&](int y) { load_penalties(y, y); });
  // Line i of a band is i * lag pixels behind its first one, so that a band is a line of its own
  // kind: pixels first to last of it are pixels first - i * lag to last - i * lag of line i.
  const int lines = frame_.lines(), length = frame_.length(), lag = lag_;
  const int bands = (lines + kBand - 1) / kBand, band_length = length + (kBand - 1) * lag;
  wavefront(bands, band_length, kBand * lag, [&](int band, int first, int last) {
    keeper.run([&] {
      const int v = band * kBand, count = std::min(kBand, lines - v);
      if (first == 0) begin_band(v, count);
      Line band_lines[kBand];
      for (int i = 0; i < count; ++i) band_lines[i] = begin_line(v + i);
      for (int u = first; u < last; ++u) {
        for (int i = 0; i < count; ++i) {
          const int own = u - i * lag;
          if (own >= 0 && own < length) visit(band_lines[i], own);
        }
      }
      if (last == band_length) progress.lines_finished(count);
    });
  });
  keeper.rethrow();
}

template <class Cell>
void PassRunner<Cell>::begin_band(int v, int count) {
  if (!frame_.lines_are_rows()) return;
  for (int i = v; i < v + count; ++i) load_penalties(lines_.slot(i), frame_.pixel(0, i).y);
}

template <class Cell>
void PassRunner<Cell>::load_penalties(int slot, int y) {
  for (Step& step : steps_) step.penalties.load(slot, y);
}

template <class Cell>
auto PassRunner<Cell>::begin_line(int v) -> Line {
  Line line;
  const int slot = lines_.slot(v);
  line.v = v;
  for (std::size_t i = 0; i < steps_.size(); ++i)
    line.back[i] = lines_.line(v - steps_[i].across) - steps_[i].along;
  line.penalty_slot = frame_.lines_are_rows() ? slot : -1;
  line.scratch = scratch_[static_cast<std::size_t>(slot)].data();
  line.has_doubles = false;
  if (same_penalties_) find_penalties(line, {0, 0});
  return line;
}

template <class Cell>
cv::Point PassRunner<Cell>::pixel_ahead(const Line& line, int u, int pixels) const {
  return frame_.pixel(std::min(u + pixels, frame_.length() - 1), line.v);
}

template <class Cell>
void PassRunner<Cell>::visit(Line& line, int u) {
  const cv::Point later = pixel_ahead(line, u, kSlicesFetchedAhead);
  __builtin_prefetch(&shape_.slice(later.y, later.x));
  const cv::Point at = frame_.pixel(u, line.v);
  const VolumeShape::Slice& slice = shape_.slice(at.y, at.x);
  const int room = VolumeShape::rounded_up(slice.count);
  Pixel& pixel = lines_.open(u, line.v, slice.begin, room);
  if (room == 0) {
    std::fill_n(pixel.least, step_.paths, kInfinite<Cell>);
    return;
  }
  PixelStep<Cell>& step = line.step;
  const std::int64_t offset = shape_.offset(at.y, slice);
  step.cost = costs_.data() + offset;
  step.sums = sums_.data() + offset;
  const cv::Point next = pixel_ahead(line, u, kCellsFetchedAhead);
  const std::int64_t next_offset = shape_.offset(next.y, next.x);
  step.next_cost = costs_.data() + next_offset;
  step.next_sums = sums_.data() + next_offset;
  step.count = slice.count;
  step.room = room;
  step.least = pixel.least;
  if (!same_penalties_ || line.has_doubles) find_penalties(line, at);
  if (step_.terms == 1) {
    find_terms<1>(line, u, pixel);
  } else {
    find_terms<2>(line, u, pixel);
  }
  extend_(step_, step);
}

template <class Cell>
void PassRunner<Cell>::find_penalties(Line& line, cv::Point at) const {
  const int slot = line.penalty_slot < 0 ? at.y : line.penalty_slot;
  const Step* step = steps_.data();
  for (int path = 0; path < step_.paths; ++path) {
    for (int i = 0; i < step_.terms; ++i, ++step) {
      Term<Cell>& term = line.step.paths[path].terms[i];
      term.classes = step->penalties.match_classes() == 1
                         ? no_classes_.data()
                         : step->penalties.classes(slot, at.x, shape_.begin(at.y, at.x));
      term.p1 = step->penalties.p1(slot, at.x);
      term.p2 = step->penalties.p2(slot, at.x);
    }
  }
}

/// Of two terms, one that does not count is replaced by the other one, whose mean with itself it
/// is. A single one may be looked at: it brings nothing.
template <class Cell>
template <int kTerms>
void PassRunner<Cell>::find_terms(Line& line, int u, const Pixel& pixel) const {
  Cell* scratch = line.scratch;
  const Pixel* const* back = line.back;
  line.has_doubles = false;
  for (int path = 0; path < step_.paths; ++path) {
    Extension<Cell>& extension = line.step.paths[path];
    extension.costs = pixel.cells + std::ptrdiff_t{pixel.stride} * path;
    for (int i = 0; i < kTerms; ++i, scratch += scratch_stride_) {
      const Pixel& previous = (*back++)[u];
      extension.terms[i].previous = previous_cells(pixel, previous, path, scratch);
      extension.terms[i].least = previous.least[path];
    }
    if constexpr (kTerms == 2) {
      const bool counts[] = {back[-2][u].counts(), back[-1][u].counts()};
      if (counts[0] == counts[1]) continue;
      extension.terms[counts[0] ? 1 : 0] = extension.terms[counts[0] ? 0 : 1];
      line.has_doubles = true;
    }
  }
}

/// L(previous, .) of a path from the first disparity of `pixel` on: as it lies there, with the
/// infinite ones on both sides, if these hold all that the pixel looks at.
template <class Cell>
const Cell* PassRunner<Cell>::previous_cells(const Pixel& pixel, const Pixel& previous, int path,
                                             Cell* scratch) const {
  const Cell* const cells = previous.cells + std::ptrdiff_t{previous.stride} * path;
  const int shift = pixel.begin - previous.begin;
  const int begin = shift - 1, end = shift + pixel.room + 1;  // what the pixel looks at
  if (begin >= -kGranule && end <= previous.room + kGranule && previous.room > 0)
    return cells + shift;
  return joined(pixel, previous, cells, scratch);
}

/// Copied in between more infinite ones.
template <class Cell>
const Cell* PassRunner<Cell>::joined(const Pixel& pixel, const Pixel& previous, const Cell* cells,
                                     Cell* scratch) {
  const int shift = pixel.begin - previous.begin;
  Cell* const first = scratch + kGranule;
  std::fill(first - kGranule, first + pixel.room + kGranule, kInfinite<Cell>);
  // Whole granules: behind the last one there are infinite costs, too.
  for (int i = std::max(0, shift - 1); i < std::min(previous.room, shift + pixel.room + 1);
       i += kGranule)
    std::copy_n(cells + i, kGranule, first + (i - shift));
  return first;
}

template class PassRunner<std::uint8_t>;
template class PassRunner<std::uint16_t>;

}  // namespace xgm::aggregation
