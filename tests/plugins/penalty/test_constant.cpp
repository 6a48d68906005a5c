// SPDX-License-Identifier: Apache-2.0
// Constant penalties.
#include "plugins/penalty/penalty_cases.hpp"

using namespace xgm;
using namespace xgm::testing;

TEST_CASE("constant gives the same penalties everywhere") {
  check_penalties("constant", [](auto&&...) { return PenaltyPair{24, 96}; });
  check_penalties("{type: constant, p1: 0, p2: 3000}", [](auto&&...) {
    return PenaltyPair{0, 3000};
  });
}

TEST_CASE("constant refuses penalties out of order or range") {
  CHECK_THROWS_AS(stage<Penalty>("{type: constant, p1: 30, p2: 29}"), Error);
  CHECK_THROWS_AS(stage<Penalty>("{type: constant, p1: -1}"), Error);
  CHECK_THROWS_AS(stage<Penalty>("{type: constant, p2: 3001}"), Error);
}
