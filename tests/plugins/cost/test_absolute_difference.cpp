// SPDX-License-Identifier: Apache-2.0
// The absolute difference against its definition.
#include <algorithm>

#include "plugins/cost/cost_cases.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

CostOracle difference_oracle(double truncation) {
  return [truncation](const ImagePair& pair, int y, int x, int d) {
    double sum = 0;
    for (std::size_t c = 0; c < pair.base.planes.size(); ++c) {
      sum += std::abs(static_cast<double>(pair.base.planes[c](y, x)) -
                      static_cast<double>(pair.match.planes[c](y, x - d)));
    }
    return std::min(sum / static_cast<double>(pair.base.planes.size()), truncation);
  };
}

}  // namespace

TEST_CASE("absolute_difference is the mean over the channels, truncated, rounded") {
  check_costs("absolute_difference", difference_oracle(64));
  check_costs("{type: absolute_difference, truncation: 1}", difference_oracle(1));
  check_costs("{type: absolute_difference, truncation: 254}", difference_oracle(254));
}

TEST_CASE("absolute_difference gives the same costs with every SIMD target") {
  check_targets("{type: absolute_difference, truncation: 90}");
}

TEST_CASE("absolute_difference is symmetric") { check_symmetry("absolute_difference"); }

TEST_CASE("absolute_difference does not depend on the number of threads") {
  check_threads("absolute_difference");
}

TEST_CASE("absolute_difference compares a grey view with a colour view in grey") {
  check_mixed_views("absolute_difference");
}

TEST_CASE("absolute_difference refuses a truncation that means no match") {
  CHECK_THROWS_AS(stage<Cost>("{type: absolute_difference, truncation: 255}"), Error);
}
