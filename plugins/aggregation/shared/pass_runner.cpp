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
  const int bands = (lines + kBand - 1) / kBand;
  return {.bands = std::min(threads + 1, bands),
          .band_lines = kBand,
          .last_lines = looked_back,
          .pixels = 2 * find_lag(pass) + 2 * kFarthest + 1};
}

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
  scratch_.assign(
      static_cast<std::size_t>(lines_.slots()),
      std::vector<Cell>(static_cast<std::size_t>(scratch_stride_) * kMostPaths * kMostTerms));
  extend_ = choose_extend_paths<Cell>(step_);
}

template <class Cell>
void PassRunner<Cell>::run(LineProgress& progress) {
  ExceptionKeeper keeper;
  // Rows of penalty classes are asked for row by row. A pass along columns crosses all rows with
  // each line, so that it needs them all beforehand.
  if (!frame_.lines_are_rows())
    parallel_for(0, shape_.height(), [&](int y) { penalties_.load(y, y); });
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
  for (int i = v; i < v + count; ++i) penalties_.load(lines_.slot(i), frame_.pixel(0, i).y);
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
  line.base_classes = -1;
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
  find_penalties(line, at, slice.begin);
  if (step_.terms == 1) {
    find_terms<1>(line, u, pixel);
  } else {
    find_terms<2>(line, u, pixel);
  }
  extend_(step_, step);
}

template <class Cell>
void PassRunner<Cell>::find_penalties(Line& line, cv::Point at, int begin) const {
  const int slot = line.penalty_slot < 0 ? at.y : line.penalty_slot;
  if (step_.match_classes > 1) line.step.classes = penalties_.match_at(slot, at.x, begin);
  const PixelClasses& base = penalties_.base();
  static constexpr std::uint8_t kOnlyClass = 0;
  const std::uint8_t* const classes = base.count() == 1 ? &kOnlyClass : base.at(slot, at.x);
  if (*classes == line.base_classes) return;
  line.base_classes = base.count() == 1 || base.packed() ? *classes : -1;
  int step = 0;
  for (int path = 0; path < step_.paths; ++path) {
    for (int i = 0; i < step_.terms; ++i, ++step) {
      Term<Cell>& term = line.step.paths[path].terms[i];
      const int base_class = base.count() == 1 ? 0 : base.get(step, classes);
      term.step = step;
      term.p1 = penalties_.p1(step, base_class);
      term.p2 = penalties_.p2(step, base_class);
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
      line.base_classes = -1;  // the term has the other one's penalties
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
