// SPDX-License-Identifier: Apache-2.0
// Memory and work of path-wise aggregation: the sums, and the path costs of the last few lines.
#pragma once

#include <vector>

#include "plugins/aggregation/path_engine/pass.hpp"
#include "xgm/stage/needs.hpp"

namespace xgm::aggregation {

/// Memory and work of aggregate_paths() with these passes and their opposites.
XGM_API Needs needs(const Workload& load, const std::vector<Pass>& passes);

}  // namespace xgm::aggregation
