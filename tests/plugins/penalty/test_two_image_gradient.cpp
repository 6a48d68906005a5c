// SPDX-License-Identifier: Apache-2.0
// P1 and P2 from the changes in both views: the paper, section 5.
#include <algorithm>
#include <cstdlib>

#include "plugins/penalty/penalty_cases.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

struct Settings {
  double p1 = 24, p2 = 96, tau = 20, q1 = 3, q2 = 6, v = 1.25;
};

PenaltyOracle two_image_oracle(Settings s) {
  return [s](const ImagePair& pair, Direction r, int y, int x, int d) {
    const double d1 = change(pair.base, r, y, x);
    const double d2 = change(pair.match, r, y, x - d);
    double q = s.q1;
    if (d1 <= s.tau && d2 <= s.tau) q = 1;
    if (d1 > s.tau && d2 > s.tau) q = s.q2;
    double p1 = s.p1 / q;
    const double p2 = s.p2 / q;
    if (r.dx == 0) {
      p1 /= s.v;
    } else if (r.dy != 0) {
      p1 *= std::sqrt(1.0 + s.v * s.v) / s.v;
    }
    const auto rounded = [](double value) { return static_cast<int>(std::floor(value + 0.5)); };
    return PenaltyPair{std::min(rounded(p1), rounded(p2)), rounded(p2)};
  };
}

}  // namespace

TEST_CASE("two_image_gradient follows the paper's cases in all directions") {
  check_penalties("two_image_gradient", two_image_oracle({}));
  check_penalties("{type: two_image_gradient, p1: 7, p2: 100, tau: 10.5, q1: 2, q2: 5.5, v: 2}",
                  two_image_oracle({7, 100, 10.5, 2, 5.5, 2}));
}

TEST_CASE("two_image_gradient keeps P1 within P2 on diagonals") {
  check_penalties("{type: two_image_gradient, p1: 50, p2: 50}", two_image_oracle({50, 50}));
}

TEST_CASE("two_image_gradient takes knight's moves as diagonals") {
  const ImagePair pair{random_image({5, 5}, 1), random_image({5, 5}, 2)};
  const auto field = stage<Penalty>("two_image_gradient")->run(pair, Context{});
  const PenaltyTable diagonal = field->table({1, 1});
  CHECK(diagonal.at(0, 0) == PenaltyPair{31, 96});
  CHECK(diagonal.at(1, 1) == PenaltyPair{5, 16});
  CHECK(field->table({-2, 1}).entries == diagonal.entries);
  CHECK(field->table({1, -2}).entries == diagonal.entries);
  CHECK(field->table({1, 0}).at(0, 1) == PenaltyPair{8, 32});
  CHECK(field->table({0, 1}).at(0, 0) == PenaltyPair{19, 96});
}

TEST_CASE("two_image_gradient refuses settings out of order") {
  CHECK_THROWS_AS(stage<Penalty>("{type: two_image_gradient, p1: 97}"), Error);
  CHECK_THROWS_AS(stage<Penalty>("{type: two_image_gradient, q1: 7}"), Error);
  CHECK_THROWS_AS(stage<Penalty>("{type: two_image_gradient, v: 0}"), Error);
}
