// SPDX-License-Identifier: Apache-2.0
// The weighted sum against the costs it adds.
#include <algorithm>

#include "plugins/cost/cost_cases.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

const char* const kCensus = "{type: census, window: 3}";
const char* const kDifference = "{type: absolute_difference, truncation: 200}";

std::string sum_of_both(const std::string& weights) {
  return std::string("{type: weighted_sum, costs: [") + kCensus + ", " + kDifference +
         "], weights: " + weights + "}";
}

/// Compares every cell with the two costs run by themselves.
void check_sum(double census_weight, double difference_weight, const std::string& yaml) {
  for (const CostCase& c : cost_cases(false)) {
    const auto shape = std::make_shared<const VolumeShape>(c.range, c.pair.base.valid);
    const CostVolume census = stage<Cost>(kCensus)->run(c.pair, shape, Context{});
    const CostVolume difference = stage<Cost>(kDifference)->run(c.pair, shape, Context{});
    const CostVolume sum = stage<Cost>(yaml)->run(c.pair, shape, Context{});
    const auto expected = [&](int a, int b) {
      return std::min(
          254, static_cast<int>(std::floor(census_weight * a + difference_weight * b + 0.5)));
    };
    int wrong = 0;
    const auto a = all_cells(census), b = all_cells(difference), both = all_cells(sum);
    for (std::size_t i = 0; i < both.size(); ++i) {
      const bool none = a[i] == 255 || b[i] == 255;
      wrong += both[i] != (none ? 255 : expected(a[i], b[i]));
    }
    CHECK_MESSAGE(wrong == 0, c.name);
    CHECK(sum.max_cost == expected(8, 200));
  }
}

}  // namespace

TEST_CASE("weighted_sum adds its costs, rounded") {
  check_sum(2.5, 0.25, sum_of_both("[2.5, 0.25]"));
  check_sum(0, 1, sum_of_both("[0, 1]"));
}

TEST_CASE("weighted_sum stops at 254") { check_sum(20, 3, sum_of_both("[20, 3]")); }

TEST_CASE("weighted_sum has no match where one of its costs has none") {
  // A mask that only one of the costs is told of would need a second pair; the border will do.
  const ImagePair pair = noisy_pair({5, 2}, 1, true, false);
  const auto shape = std::make_shared<const VolumeShape>(
      DisparityRange::uniform(pair.size(), {-6, 7}), pair.base.valid);
  const CostVolume sum = stage<Cost>(sum_of_both("[1, 0]"))->run(pair, shape, Context{});
  const CostVolume census = stage<Cost>(kCensus)->run(pair, shape, Context{});
  CHECK(all_cells(sum) == all_cells(census));
}

TEST_CASE("weighted_sum is symmetric") { check_symmetry(sum_of_both("[2.5, 0.25]")); }

TEST_CASE("weighted_sum does not depend on the number of threads") {
  check_threads(sum_of_both("[2.5, 0.25]"));
}

TEST_CASE("weighted_sum wants one weight for each cost, and one that is not 0") {
  CHECK_THROWS_AS(stage<Cost>(sum_of_both("[1]")), Error);
  CHECK_THROWS_AS(stage<Cost>(sum_of_both("[1, 2, 3]")), Error);
  CHECK_THROWS_AS(stage<Cost>(sum_of_both("[0, 0]")), Error);
  CHECK_THROWS_AS(stage<Cost>(sum_of_both("[1, -1]")), Error);
  CHECK_THROWS_AS(stage<Cost>("weighted_sum"), Error);
}
