// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/path_engine/aggregate.hpp"

#include "plugins/aggregation/path_engine/fixed_point.hpp"
#include "plugins/aggregation/path_engine/run_opposed_passes.hpp"
#include "xgm/base/error.hpp"

namespace xgm::aggregation {
namespace {

/// Whether the first values of the sums are written past the caches. That saves reading memory
/// before it is written; it pays if the caches would keep none of it until the next pass, and
/// requires that sums are written in whole cache lines.
bool begin_past_caches(const AggregatedVolume& sums, std::size_t larger_than_caches) {
  const VolumeShape& shape = sums.shape();
  const int room = VolumeShape::rounded_up(shape.max_count());
  const bool dense = shape.cells() == std::int64_t{shape.width()} * shape.height() * room;
  const bool whole_lines =
      static_cast<std::size_t>(room) * sizeof(std::uint16_t) % kBufferAlignment == 0;
  return dense && whole_lines && sums.bytes() >= larger_than_caches;
}

template <class Cell>
void run_passes(const CostVolume& costs, const PenaltyField& penalties,
                const std::vector<Pass>& passes, const Bounds& bounds, bool past_caches,
                AggregatedVolume& sums, const Context& context) {
  const PathLayout layout(costs.shape(), sizeof(Cell));
  const double share = 1.0 / static_cast<double>(passes.size());
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const auto [pass, opposite] = both_directions(passes[i]);
    PassStep step;
    step.past_caches = past_caches;
    step.bits = sums.fraction_bits;
    step.cost_weight = bounds.cost_weight;
    step.p2 = bounds.p2 << step.bits;
    step.always_room = ((bounds.max_cost + bounds.p2) << step.bits) + step.p2 < kInfinite<Cell>;
    const int lines = PassFrame(costs.shape().size(), pass.along, pass.across).lines();
    PassWalk<Cell> forward(costs, penalties, pass, layout, step, sums, 0);
    PassWalk<Cell> backward(costs, penalties, opposite, layout, step, sums,
                            first_backward_line(lines));
    const double done = share * static_cast<double>(i);
    LineProgress progress(context.part(done, done + share), 2 * lines);
    run_opposed_passes(forward, backward, i == 0, progress);
    context.progress(done + share);  // the last line may have been another thread's
  }
}

bool use_8_bit(PathCostWidth width, const Bounds& bounds, int fraction_bits) {
  const bool fits = fits_path_costs(bounds, fraction_bits, kInfinite<std::uint8_t>);
  if (width == PathCostWidth::bits8 && !fits)
    throw Error("path costs do not fit 8 bit; let them have 16");
  return fits && width != PathCostWidth::bits16;
}

}  // namespace

AggregatedVolume aggregate_paths(const CostVolume& costs, const PenaltyField& penalties,
                                 const std::vector<Pass>& passes, const AggregationOptions& options,
                                 const Context& context) {
  // L = C + message, so the messages of all N paths sum to S - N C. With the overcounting
  // correction, S - (N - 1) C, C is added to that once; without it, N times.
  const Bounds bounds = find_bounds(costs, penalties, passes, options.overcounting_correction);
  AggregatedVolume sums(costs.shape_ptr(), choose_fraction_bits(bounds));
  if (costs.shape().cells() == 0) return sums;
  const bool past_caches = begin_past_caches(sums, options.larger_than_caches);
  if (use_8_bit(options.width, bounds, sums.fraction_bits))
    run_passes<std::uint8_t>(costs, penalties, passes, bounds, past_caches, sums, context);
  else
    run_passes<std::uint16_t>(costs, penalties, passes, bounds, past_caches, sums, context);
  return sums;
}

}  // namespace xgm::aggregation
