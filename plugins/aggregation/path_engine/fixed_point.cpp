// SPDX-License-Identifier: Apache-2.0
#include "plugins/aggregation/path_engine/fixed_point.hpp"

#include <algorithm>
#include <string>

#include "plugins/aggregation/path_engine/pixel_step.hpp"
#include "xgm/base/error.hpp"

namespace xgm::aggregation {
namespace {

constexpr std::int64_t kLargestSum = AggregatedVolume::kNoMatch - 1;

std::int64_t largest_sum(const Bounds& bounds) {
  return std::int64_t{bounds.cost_weight} * bounds.max_cost +
         std::int64_t{bounds.paths} * bounds.p2;
}

void include_penalties(const PenaltyTable& table, Bounds& bounds) {
  for (const PenaltyPair& pair : table.entries) {
    if (pair.p1 < 0 || pair.p2 < pair.p1)
      throw Error("the penalties P1 = " + std::to_string(pair.p1) +
                  ", P2 = " + std::to_string(pair.p2) +
                  " do not hold 0 <= P1 <= P2; correct the penalty stage");
    bounds.p1 = std::max(bounds.p1, pair.p1);
    bounds.p2 = std::max(bounds.p2, pair.p2);
  }
}

}  // namespace

Bounds find_bounds(const CostVolume& costs, const PenaltyField& penalties,
                   const std::vector<Pass>& passes, bool overcounting_correction) {
  Bounds bounds;
  bounds.max_cost = costs.max_cost;
  const auto include_pass = [&](const Pass& pass) {
    for (const Path& path : pass.paths) {
      ++bounds.paths;
      bounds.has_means = bounds.has_means || path.steps.size() > 1;
      for (const Direction step : path.steps) include_penalties(penalties.table(step), bounds);
    }
  };
  for (const Pass& pass : passes) std::ranges::for_each(both_directions(pass), include_pass);
  bounds.cost_weight = overcounting_correction ? 1 : bounds.paths;
  return bounds;
}

int choose_fraction_bits(const Bounds& bounds) {
  const std::int64_t sum = largest_sum(bounds);
  if (sum > kLargestSum) {
    const std::int64_t room = kLargestSum - std::int64_t{bounds.cost_weight} * bounds.max_cost;
    throw Error("sums of " + std::to_string(bounds.paths) + " directions with P2 = " +
                std::to_string(bounds.p2) + " do not fit 16 bit; lower P2 to at most " +
                std::to_string(room / bounds.paths) + ", or take fewer directions");
  }
  if (!bounds.has_means || sum == 0) return 0;
  int bits = 0;
  while (sum << (bits + 1) <= kLargestSum) ++bits;
  int bits8 = 0;
  while (bits8 < bits && fits_path_costs(bounds, bits8 + 1, kInfinite<std::uint8_t>)) ++bits8;
  return bits8 > 0 ? bits8 : bits;
}

bool fits_path_costs(const Bounds& bounds, int fraction_bits, int infinite) {
  return (std::int64_t{bounds.max_cost} + bounds.p2) << fraction_bits < infinite;
}

}  // namespace xgm::aggregation
