// SPDX-License-Identifier: Apache-2.0
// P2 over gradient, Hirschmueller 2008.
#include <algorithm>

#include "plugins/penalty/penalty_cases.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

PenaltyOracle gradient_oracle(int p1, int p2) {
  return [=](const ImagePair& pair, Direction r, int y, int x, int) {
    const double levels = std::floor(change(pair.base, r, y, x) + 0.5);
    const double adapted = std::floor(p2 / std::max(levels, 1.0) + 0.5);
    return PenaltyPair{p1, std::max(p1, static_cast<int>(adapted))};
  };
}

}  // namespace

TEST_CASE("gradient divides P2 by the change of intensity in whole levels, down to P1") {
  check_penalties("gradient", gradient_oracle(24, 96));
  check_penalties("{type: gradient, p1: 2, p2: 3000}", gradient_oracle(2, 3000));
  check_penalties("{type: gradient, p1: 0, p2: 1}", gradient_oracle(0, 1));
}

TEST_CASE("gradient knows changes beyond 255 levels and below one") {
  ImagePair pair{Image(cv::Mat1f(1, 4)), Image(cv::Mat1f(1, 4, 0.0F))};
  pair.base.planes[0] << 0.0F, 0.4F, 900.0F, 898.0F;
  const auto field = stage<Penalty>("{type: gradient, p1: 1, p2: 1000}")->run(pair, Context{});
  std::vector<std::uint8_t> base(4), match(4);
  field->classify({1, 0}, 0, base, match);
  const PenaltyTable table = field->table({1, 0});
  CHECK(table.at(base[1], 0) == PenaltyPair{1, 1000});
  CHECK(table.at(base[2], 0) == PenaltyPair{1, 4});
  CHECK(table.at(base[3], 0) == PenaltyPair{1, 500});
}

TEST_CASE("gradient refuses penalties out of order") {
  CHECK_THROWS_AS(stage<Penalty>("{type: gradient, p1: 97}"), Error);
}
