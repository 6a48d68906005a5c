// SPDX-License-Identifier: Apache-2.0
// The plain code is compared with Eq. 3 to 6 by the other tests; here all others with the plain
// code.
#include <algorithm>

#include "inputs.hpp"
#include "plugins/aggregation/mgm/passes.hpp"
#include "plugins/aggregation/path_engine/aggregate.hpp"
#include "plugins/aggregation/sgm/passes.hpp"
#include "xgm/base/simd.hpp"

using namespace xgm;
using namespace xgm::testing;
using aggregation::PathCostWidth;

namespace {

AggregatedVolume aggregate(const std::string& target, const CostVolume& costs,
                           const PenaltyField& penalties,
                           const std::vector<aggregation::Pass>& passes, PathCostWidth width,
                           std::size_t larger_than_caches = std::size_t{1} << 30) {
  const SimdChoice choice(target);
  return aggregation::aggregate_paths(costs, penalties, passes,
                                      {.width = width, .larger_than_caches = larger_than_caches},
                                      Context{});
}

void check_targets(const CostVolume& costs, const PenaltyField& penalties) {
  for (const int directions : {4, 8, 16}) {
    for (const auto& passes : {sgm::passes(directions), mgm::passes(directions)}) {
      for (const PathCostWidth width : {PathCostWidth::bits8, PathCostWidth::bits16}) {
        const auto expected = aggregate("scalar", costs, penalties, passes, width);
        for (const std::string& target : simd_targets()) {
          CAPTURE(target);
          CAPTURE(directions);
          CAPTURE(passes.size());
          CHECK(identical(aggregate(target, costs, penalties, passes, width), expected));
        }
      }
    }
  }
}

/// Slices of about `count` disparities that begin near those of their neighbours, as pyramids have
/// them: path costs of previous pixels are read where they are.
VolumeShapePtr drifting_shape(cv::Size size, int count, std::uint64_t seed) {
  Random random(seed);
  cv::Mat1i begin(size), end(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      begin(y, x) = x / 8 + random.integer(-3, 3);
      end(y, x) = begin(y, x) + std::max(1, count + random.integer(-4, 4));
    }
  }
  return std::make_shared<VolumeShape>(DisparityRange(begin, end));
}

}  // namespace

TEST_CASE("every SIMD target gives the same sums on dense volumes, from one disparity to many") {
  for (const int disparities : {1, 15, 16, 17, 33, 64, 100, 128, 240}) {
    CAPTURE(disparities);
    const auto shape = dense_shape({23, 9}, {-disparities / 3, disparities - disparities / 3});
    check_targets(random_costs(shape, 24, 7), ConstantPenalties(10, 90));
    check_targets(random_costs(shape, 24, 8), RandomPenalties(3, 2, 90, 8));
  }
}

TEST_CASE("every SIMD target gives the same sums on ragged volumes") {
  for (const Interval hull : {Interval{0, 7}, {-20, 21}, {-60, 90}, {3, 300}}) {
    CAPTURE(hull.end);
    const auto shape = ragged_shape({41, 13}, hull, 3);
    check_targets(random_costs(shape, 24, 3), ConstantPenalties(0, 60));
    check_targets(random_costs(shape, 24, 4), RandomPenalties(1, 2, 90, 4));
    check_targets(random_costs(shape, 24, 5), RandomPenalties(2, 4, 90, 5));
  }
}

TEST_CASE("every SIMD target gives the same sums where slices fit one vector, or nearly") {
  for (const int count : {2, 12, 16, 28, 32, 44, 60, 64, 72}) {
    CAPTURE(count);
    const auto shape = drifting_shape({45, 17}, count, 5);
    check_targets(random_costs(shape, 24, 6), ConstantPenalties(5, 60));
    check_targets(random_costs(shape, 24, 7), RandomPenalties(2, 1, 90, 7));
    check_targets(random_costs(shape, 24, 8), RandomPenalties(2, 2, 90, 8));
    check_targets(random_costs(shape, 60, 9), RandomPenalties(2, 2, 60, 9));
  }
}

TEST_CASE("sums that are begun past the caches are the same") {
  // For dense volumes in whole cache lines.
  for (const int disparities : {32, 96, 256}) {
    const auto shape = dense_shape({50, 21}, {0, disparities});
    const CostVolume costs = random_costs(shape, 24, 9);
    const ConstantPenalties penalties(10, 90);
    for (const int directions : {4, 16}) {
      const auto passes = sgm::passes(directions);
      const auto expected = aggregate("scalar", costs, penalties, passes, PathCostWidth::bits8);
      for (const std::string& target : simd_targets()) {
        for (const PathCostWidth width : {PathCostWidth::bits8, PathCostWidth::bits16}) {
          CAPTURE(target);
          CAPTURE(disparities);
          CHECK(identical(aggregate(target, costs, penalties, passes, width, 0), expected));
        }
      }
    }
  }
}
