// SPDX-License-Identifier: Apache-2.0
// Parameters that sgm and mgm share.
#pragma once

#include "xgm/config/parameters.hpp"

namespace xgm::aggregation {

struct PathParameters {
  int directions = 8;
  bool overcounting_correction = true;
};

void describe(PathParameters& parameters, ParameterSet& set);

}  // namespace xgm::aggregation
