// SPDX-License-Identifier: Apache-2.0
// The parameters that all penalties have, declared once.
#pragma once

#include "xgm/config/parameters.hpp"

namespace xgm::penalty {

/// Defaults: the paper, section 4.1.
struct Weights {
  int p1 = 24;
  int p2 = 96;
};

/// Adds p1 and p2, and the rule that they are in order.
void describe(Weights& weights, ParameterSet& set);

/// Adds one more penalty in units of the cost.
void describe(std::string name, int& penalty, std::string text, ParameterSet& set);

}  // namespace xgm::penalty
