// SPDX-License-Identifier: Apache-2.0
// What path-wise aggregations take: the sums, and beside them the path costs of the last few lines.
#pragma once

#include <vector>

#include "plugins/aggregation/path_engine/pass.hpp"
#include "xgm/stage/needs.hpp"

namespace xgm::aggregation {

/// What aggregate_paths() takes with these passes and their opposites.
XGM_API Needs needs(const Workload& load, const std::vector<Pass>& passes);

}  // namespace xgm::aggregation
