// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/shared/aggregate.hpp"

#include <limits>

#include "plugins/aggregation/shared/fixed_point.hpp"
#include "plugins/aggregation/shared/pass_runner.hpp"
#include "xgm/base/error.hpp"

namespace xgm::aggregation {
namespace {

template <class Cell>
void run_passes(const CostVolume& costs, const PenaltyField& penalties,
                const std::vector<Pass>& passes, const Bounds& bounds, FractionBits bits,
                AggregatedVolume& sums, const Context& context) {
  const int unit = 1 << bits.paths;
  const PathArithmetic<Cell> arithmetic{
      .unit = static_cast<Cell>(unit),
      .infinite = static_cast<Cell>(std::numeric_limits<Cell>::max() - unit * bounds.p1),
      .extra_bits = bits.paths - bits.sums,
      .cost_unit = static_cast<std::uint16_t>(bounds.cost_weight << bits.sums)};
  const double share = 1.0 / static_cast<double>(passes.size());
  for (std::size_t i = 0; i < passes.size(); ++i) {
    PassRunner<Cell> runner(costs, penalties, passes[i], arithmetic, sums);
    const double done = share * static_cast<double>(i);
    LineProgress progress(context.part(done, done + share), runner.lines());
    runner.run(i == 0, progress);
  }
}

bool use_8_bit(PathCostWidth width, const Bounds& bounds) {
  const bool fits =
      !bounds.has_means && fits_path_costs(bounds, 1, std::numeric_limits<std::uint8_t>::max());
  if (width == PathCostWidth::bits8 && !fits)
    throw Error("path costs do not fit 8 bit; let them have 16");
  return fits && width != PathCostWidth::bits16;
}

}  // namespace

AggregatedVolume aggregate_paths(const CostVolume& costs, const PenaltyField& penalties,
                                 const std::vector<Pass>& passes, const AggregationOptions& options,
                                 const Context& context) {
  // L = C + what the path brings. The sum of the latter is S - N C, so that with the overcounting
  // correction, S - (N - 1) C, just one C is added to it.
  const Bounds bounds = find_bounds(costs, penalties, passes, options.overcounting_correction);
  const FractionBits bits = choose_fraction_bits(bounds);
  AggregatedVolume sums(costs.shape_ptr(), bits.sums);
  if (costs.shape().cells() == 0) return sums;
  if (use_8_bit(options.width, bounds))
    run_passes<std::uint8_t>(costs, penalties, passes, bounds, bits, sums, context);
  else
    run_passes<std::uint16_t>(costs, penalties, passes, bounds, bits, sums, context);
  return sums;
}

}  // namespace xgm::aggregation
