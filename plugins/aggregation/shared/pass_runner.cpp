// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/shared/pass_runner.hpp"

#include <algorithm>

#include "xgm/base/parallel.hpp"

namespace xgm::aggregation {
namespace {

constexpr int kLinesLookedBack = 2;

}  // namespace

template <class Cell>
PassRunner<Cell>::Scratch::Scratch(int max_count) {
  const auto count = static_cast<std::size_t>(max_count);
  sum.resize(count);
  for (OfStep& step : of_step) {
    step.joined.resize(count + 2);
    step.p1.resize(count);
    step.p2.resize(count);
  }
}

template <class Cell>
PassRunner<Cell>::PassRunner(const CostVolume& costs, const PenaltyField& penalties,
                             const Pass& pass, const PathArithmetic<Cell>& arithmetic,
                             AggregatedVolume& sums)
    : costs_(costs),
      shape_(costs.shape()),
      sums_(sums),
      arithmetic_(arithmetic),
      frame_(shape_.size(), pass.along, pass.across),
      lines_(shape_, frame_, static_cast<int>(pass.paths.size()),
             std::min(thread_count() + kLinesLookedBack, frame_.lines()), arithmetic.infinite),
      scratch_(static_cast<std::size_t>(lines_.slots()), Scratch(shape_.max_count())) {
  const int penalty_slots = frame_.lines_are_rows() ? lines_.slots() : shape_.height();
  for (const Path& path : pass.paths) {
    std::vector<Step>& steps = paths_.emplace_back();
    for (const Direction x : path.steps)
      steps.push_back({pixels_along(x, pass.along),
                       lines_across(x, pass.across),
                       {penalties, x, penalty_slots, shape_.width(), arithmetic.unit}});
  }
}

template <class Cell>
void PassRunner<Cell>::run(bool first_pass, LineProgress& progress) {
  ExceptionKeeper keeper;
  // Rows of penalty classes are asked for row by row. A pass along columns crosses all rows with
  // each line, so that it needs them all beforehand.
  if (!frame_.lines_are_rows())
    parallel_for(0, shape_.height(), [&](int y) { load_penalties(y, y); });
  wavefront(frame_.lines(), frame_.length(), lag(), [&](int v, int first, int last) {
    keeper.run([&] {
      if (first == 0 && frame_.lines_are_rows())
        load_penalties(lines_.slot(v), frame_.pixel(0, v).y);
      for (int u = first; u < last; ++u) visit(pixel(u, v), first_pass);
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
auto PassRunner<Cell>::pixel(int u, int v) const -> Pixel {
  const cv::Point at = frame_.pixel(u, v);
  return {u,
          v,
          at,
          shape_.begin(at.y, at.x),
          shape_.count(at.y, at.x),
          frame_.lines_are_rows() ? lines_.slot(v) : at.y};
}

template <class Cell>
void PassRunner<Cell>::visit(const Pixel& p, bool first_pass) {
  Scratch& scratch = scratch_[static_cast<std::size_t>(lines_.slot(p.v))];
  lines_.open(p.u, p.v, p.count);
  std::fill_n(scratch.sum.begin(), p.count, PassSum<Cell>{0});
  for (int path = 0; path < static_cast<int>(paths_.size()); ++path) extend_path(p, path, scratch);

  std::uint16_t* const sums = sums_.at(p.at.y, p.at.x);
  if (first_pass)
    write_sums(costs_.at(p.at.y, p.at.x), scratch.sum.data(), p.count, arithmetic_.extra_bits,
               arithmetic_.cost_unit, sums);
  else
    add_sums(scratch.sum.data(), p.count, arithmetic_.extra_bits, sums);
}

template <class Cell>
void PassRunner<Cell>::extend_path(const Pixel& p, int path, Scratch& scratch) {
  Previous previous[2];
  int found = 0;
  for (const Step& step : paths_[static_cast<std::size_t>(path)])
    if (const auto here = look_back(p, step, path, scratch.of_step[found].joined))
      previous[found++] = *here;
  const PathCosts<Cell> extended = lines_.costs(p.u, p.v, path, p.count);
  *extended.least = extend_from(p, previous, found, extended.cells, scratch);
}

/// Nothing if there is no p - x, or no match for it at all.
template <class Cell>
auto PassRunner<Cell>::look_back(const Pixel& p, const Step& step, int path,
                                 std::vector<Cell>& joined) -> std::optional<Previous> {
  const int u = p.u - step.along, v = p.v - step.across;
  if (u < 0 || u >= frame_.length() || v < 0) return {};
  const cv::Point at = frame_.pixel(u, v);
  const int begin = shape_.begin(at.y, at.x), count = shape_.count(at.y, at.x);
  const PathCosts<Cell> costs = lines_.costs(u, v, path, count);
  if (*costs.least == lines_.infinite()) return {};

  const int shift = p.begin - begin;
  if (shift >= 0 && shift + p.count <= count)  // all of p's disparities, with neighbours
    return Previous{costs.cells + shift, *costs.least, &step.penalties};
  std::fill_n(joined.begin(), p.count + 2, lines_.infinite());
  const int common_begin = std::max(p.begin - 1, begin);
  const int common_end = std::min(p.begin + p.count + 1, begin + count);
  if (common_begin < common_end)
    std::copy(costs.cells + (common_begin - begin), costs.cells + (common_end - begin),
              joined.begin() + (common_begin - (p.begin - 1)));
  return Previous{joined.data() + 1, *costs.least, &step.penalties};
}

/// Returns the least of the new path costs.
template <class Cell>
Cell PassRunner<Cell>::extend_from(const Pixel& p, const Previous* previous, int count, Cell* path,
                                   Scratch& scratch) const {
  const auto extend_by = [&](auto term) {
    return extend<Cell>(term, costs_.at(p.at.y, p.at.x), p.count, arithmetic_.unit,
                        arithmetic_.infinite, path, scratch.sum.data());
  };
  const auto same_term = [&](int i) -> Term<Cell, SamePenalties<Cell>> {
    return {previous[i].cells, previous[i].least,
            previous[i].penalties->of_pixel(p.penalty_slot, p.at.x)};
  };
  const auto cell_term = [&](int i) -> Term<Cell, CellPenalties<Cell>> {
    auto& [joined, p1, p2] = scratch.of_step[i];
    previous[i].penalties->of_cells(p.penalty_slot, p.at.x, p.begin, p.count, p1.data(), p2.data());
    return {previous[i].cells, previous[i].least, {p1.data(), p2.data()}};
  };
  if (count == 0) return extend_by(NoTerm<Cell>{});
  const bool same = std::all_of(previous, previous + count, [](const Previous& each) {
    return each.penalties->same_for_all_disparities();
  });
  if (count == 1) return same ? extend_by(same_term(0)) : extend_by(cell_term(0));
  return same ? extend_by(MeanTerm<Cell, SamePenalties<Cell>>{same_term(0), same_term(1)})
              : extend_by(MeanTerm<Cell, CellPenalties<Cell>>{cell_term(0), cell_term(1)});
}

template class PassRunner<std::uint8_t>;
template class PassRunner<std::uint16_t>;

}  // namespace xgm::aggregation
