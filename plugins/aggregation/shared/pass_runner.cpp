// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/shared/pass_runner.hpp"

#include <algorithm>

#include "xgm/base/parallel.hpp"

namespace xgm::aggregation {
namespace {

constexpr int kPixelsFetchedAhead = 4;
constexpr int kGranule = VolumeShape::kGranule;

int rounded_up(int count) { return (count + kGranule - 1) / kGranule * kGranule; }

}  // namespace

template <class Cell>
PassRunner<Cell>::PassRunner(const CostVolume& costs, const PenaltyField& penalties,
                             const Pass& pass, PassStep step, AggregatedVolume& sums)
    : costs_(costs),
      shape_(costs.shape()),
      sums_(sums),
      step_(step),
      frame_(shape_.size(), pass.along, pass.across),
      lines_(shape_, frame_, static_cast<int>(pass.paths.size()),
             std::min(thread_count() + kLinesLookedBack, frame_.lines())),
      // A slice, a granule before it, and what copying whole granules writes behind it.
      scratch_stride_(rounded_up(shape_.max_count()) + 3 * kGranule) {
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
  nothing_.assign(stride, 0);
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
  wavefront(frame_.lines(), frame_.length(), lag(), [&](int v, int first, int last) {
    keeper.run([&] {
      if (first == 0 && frame_.lines_are_rows())
        load_penalties(lines_.slot(v), frame_.pixel(0, v).y);
      Line line = begin_line(v);
      for (int u = first; u < last; ++u) visit(line, u);
      if (last == frame_.length()) progress.line_finished();
    });
  });
  keeper.rethrow();
}

/// How far line v - 1 must be ahead of line v.
template <class Cell>
int PassRunner<Cell>::lag() const {
  int lag = 0;
  for (const Step& step : steps_)
    if (step.across > 0) lag = std::max(lag, (-step.along + step.across - 1) / step.across);
  return lag;
}

template <class Cell>
void PassRunner<Cell>::load_penalties(int slot, int y) {
  for (Step& step : steps_) step.penalties.load(slot, y);
}

template <class Cell>
auto PassRunner<Cell>::begin_line(int v) -> Line {
  Line line{};
  const int slot = lines_.slot(v);
  line.v = v;
  for (int i = 0; i <= kLinesLookedBack && i <= v; ++i) line.back[i] = lines_.line(v - i);
  line.penalty_slot = frame_.lines_are_rows() ? slot : -1;
  line.scratch = scratch_[static_cast<std::size_t>(slot)].data();
  if (same_penalties_) find_penalties(line, {0, 0});
  return line;
}

template <class Cell>
void PassRunner<Cell>::visit(Line& line, int u) {
  const cv::Point at = frame_.pixel(u, line.v);
  const VolumeShape::Slice& slice = shape_.slice(at.y, at.x);
  const int room = VolumeShape::rounded_up(slice.count);
  Pixel& pixel = lines_.open(u, line.v, slice.begin, room);
  if (room == 0) return;
  PixelStep<Cell>& step = line.step;
  const std::int64_t offset = shape_.offset(at.y, slice);
  step.cost = costs_.data() + offset;
  step.sums = sums_.data() + offset;
  const cv::Point next =
      frame_.pixel(std::min(u + kPixelsFetchedAhead, frame_.length() - 1), line.v);
  const std::int64_t next_offset = shape_.offset(next.y, next.x);
  step.next_cost = costs_.data() + next_offset;
  step.next_sums = sums_.data() + next_offset;
  step.count = slice.count;
  step.room = room;
  if (!same_penalties_ || line.has_doubles) find_penalties(line, at);
  find_terms(line, u, pixel);
  pixel.counts = extend_(step_, step);
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

/// A term that does not count is replaced by the other one, whose mean with itself it is; if none
/// counts, both bring nothing.
template <class Cell>
void PassRunner<Cell>::find_terms(Line& line, int u, const Pixel& pixel) const {
  Cell* scratch = line.scratch;
  const Step* step = steps_.data();
  line.has_doubles = false;
  for (int path = 0; path < step_.paths; ++path) {
    Extension<Cell>& extension = line.step.paths[path];
    extension.costs = pixel.cells + std::ptrdiff_t{pixel.stride} * path;
    const Term<Cell>* counting = nullptr;
    for (int i = 0; i < step_.terms; ++i, ++step) {
      Term<Cell>& term = extension.terms[i];
      const Pixel* const previous = look_back(line, u, *step);
      term.previous = nullptr;
      if (previous == nullptr) continue;
      const Cell* const cells = previous->cells + std::ptrdiff_t{previous->stride} * path;
      term.previous = joined(pixel, *previous, cells, scratch);
      scratch += scratch_stride_;
      counting = &term;
    }
    for (int i = 0; i < step_.terms; ++i) {
      Term<Cell>& term = extension.terms[i];
      if (term.previous != nullptr) continue;
      if (counting == nullptr) {
        term.previous = nothing_.data() + kGranule;
      } else {
        term = *counting;
        line.has_doubles = true;
      }
    }
  }
}

/// nullptr if there is no p - x, or no match for it at all.
template <class Cell>
auto PassRunner<Cell>::look_back(const Line& line, int u, const Step& step) const -> const Pixel* {
  const Pixel* const pixels = line.back[step.across];
  const int before = u - step.along;
  if (pixels == nullptr || before < 0 || before >= frame_.length()) return nullptr;
  return pixels[before].counts ? pixels + before : nullptr;
}

/// The `cells` of p - x from the first disparity of p on: as they lie there, with the infinite ones
/// on both sides, if these hold all that p looks at; else copied in between more infinite ones.
template <class Cell>
const Cell* PassRunner<Cell>::joined(const Pixel& pixel, const Pixel& previous, const Cell* cells,
                                     Cell* scratch) const {
  const int shift = pixel.begin - previous.begin;
  const int begin = shift - 1, end = shift + pixel.room + 1;  // what p looks at
  if (begin >= -kGranule && end <= previous.room + kGranule) return cells + shift;
  Cell* const first = scratch + kGranule;
  std::fill(first - kGranule, first + pixel.room + kGranule, kInfinite<Cell>);
  // Whole granules: behind the last one there are infinite costs, too.
  for (int i = std::max(0, begin); i < std::min(previous.room, end); i += kGranule)
    std::copy_n(cells + i, kGranule, first + (i - shift));
  return first;
}

template class PassRunner<std::uint8_t>;
template class PassRunner<std::uint16_t>;

}  // namespace xgm::aggregation
