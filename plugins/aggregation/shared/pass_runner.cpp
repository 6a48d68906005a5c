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
  for (const Path& path : pass.paths) {
    std::vector<Step>& steps = paths_.emplace_back();
    for (const Direction x : path.steps) {
      steps.push_back({pixels_along(x, pass.along), lines_across(x, pass.across),
                       StepPenalties<Cell>(penalties, x, penalty_slots, shape_.width(),
                                           shape_.hull(), 1 << step.bits)});
      step_.match_classes = std::max(step_.match_classes, steps.back().penalties.match_classes());
    }
    step_.terms = std::max(step_.terms, static_cast<int>(steps.size()));
  }
  const auto stride = static_cast<std::size_t>(scratch_stride_);
  nothing_.assign(stride, 0);
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
      const int slot = lines_.slot(v);
      if (first == 0 && frame_.lines_are_rows()) load_penalties(slot, frame_.pixel(0, v).y);
      Line line{v,
                {},
                frame_.lines_are_rows() ? slot : -1,
                scratch_[static_cast<std::size_t>(slot)].data()};
      for (int i = 0; i <= kLinesLookedBack && i <= v; ++i) line.back[i] = lines_.line(v - i);
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
  for (const std::vector<Step>& path : paths_)
    for (const Step& step : path)
      if (step.across > 0) lag = std::max(lag, (-step.along + step.across - 1) / step.across);
  return lag;
}

template <class Cell>
void PassRunner<Cell>::load_penalties(int slot, int y) {
  for (std::vector<Step>& path : paths_)
    for (Step& step : path) step.penalties.load(slot, y);
}

template <class Cell>
void PassRunner<Cell>::visit(const Line& line, int u) {
  const cv::Point at = frame_.pixel(u, line.v);
  const cv::Point next =
      frame_.pixel(std::min(u + kPixelsFetchedAhead, frame_.length() - 1), line.v);
  PixelStep<Cell> step;
  step.cost = costs_.at(at.y, at.x);
  step.sums = sums_.at(at.y, at.x);
  step.next_cost = costs_.at(next.y, next.x);
  step.next_sums = sums_.at(next.y, next.x);
  step.count = shape_.count(at.y, at.x);
  step.room = shape_.room(at.y, at.x);
  Pixel& pixel = lines_.open(u, line.v, shape_.begin(at.y, at.x), step.room);
  if (step.count == 0) return;
  find_terms(line, u, at, pixel, step);
  pixel.counts = extend_(step_, step);
}

/// A term that does not count is replaced by the other one, whose mean with itself it is; if none
/// counts, both bring nothing.
template <class Cell>
void PassRunner<Cell>::find_terms(const Line& line, int u, cv::Point at, const Pixel& pixel,
                                  PixelStep<Cell>& step) const {
  const int slot = line.penalty_slot < 0 ? at.y : line.penalty_slot;
  Cell* scratch = line.scratch;
  for (int path = 0; path < step_.paths; ++path) {
    Extension<Cell>& extension = step.paths[path];
    extension.costs = pixel.cells + std::ptrdiff_t{pixel.stride} * path;
    int found = 0;
    for (const Step& back : paths_[static_cast<std::size_t>(path)]) {
      Term<Cell>& term = extension.terms[found];
      term.classes = back.penalties.classes(slot, at.x, pixel.begin);
      term.p1 = back.penalties.p1(slot, at.x);
      term.p2 = back.penalties.p2(slot, at.x);
      const Pixel* const previous = look_back(line, u, back);
      if (previous == nullptr) continue;
      const Cell* const cells = previous->cells + std::ptrdiff_t{previous->stride} * path;
      term.previous = joined(pixel, *previous, cells, scratch);
      scratch += scratch_stride_;
      ++found;
    }
    if (found == 0) extension.terms[found++].previous = nothing_.data() + kGranule;
    if (found < step_.terms) extension.terms[1] = extension.terms[0];
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

/// The `cells` of p - x from the first disparity of p on: as they lie there if they hold all that
/// p needs, else copied in between infinite ones.
template <class Cell>
const Cell* PassRunner<Cell>::joined(const Pixel& pixel, const Pixel& previous, const Cell* cells,
                                     Cell* scratch) const {
  const int shift = pixel.begin - previous.begin;
  if (shift >= 0 && shift + pixel.room <= previous.room) return cells + shift;
  Cell* const first = scratch + kGranule;
  std::fill(first - kGranule, first + pixel.room + kGranule, kInfinite<Cell>);
  const int begin = std::max(0, shift - 1);
  const int end = std::min(previous.room, shift + pixel.room + 1);
  // Whole granules: behind the end there are more costs, or the infinite ones of the margin.
  for (int i = begin; i < end; i += kGranule) std::copy_n(cells + i, kGranule, first + (i - shift));
  return first;
}

template class PassRunner<std::uint8_t>;
template class PassRunner<std::uint16_t>;

}  // namespace xgm::aggregation
