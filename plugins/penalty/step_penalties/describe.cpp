// SPDX-License-Identifier: Apache-2.0
// The declarations of P1 and P2.
#include "plugins/penalty/step_penalties/describe.hpp"

#include <utility>

namespace xgm::penalty {

void describe(Weights& weights, ParameterSet& set) {
  describe("p1", weights.p1, "Penalty P1 of a disparity step of one.", set);
  describe("p2", weights.p2, "Penalty P2 of a larger disparity step.", set);
  set.rule({"p2", "p1"}, "must not be below p1", [&weights] { return weights.p2 >= weights.p1; });
}

void describe(std::string name, int& penalty, std::string text, ParameterSet& set) {
  set.add(std::move(name), penalty, std::move(text)).unit("cost units").range(0, 3000);
}

}  // namespace xgm::penalty
