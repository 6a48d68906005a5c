// SPDX-License-Identifier: Apache-2.0
// Runs one pass on all threads.
#pragma once

#include "plugins/aggregation/shared/line_progress.hpp"
#include "plugins/aggregation/shared/pass_walk.hpp"

namespace xgm::aggregation {

/// Tells `progress` of each line.
template <class Cell>
void run_pass(PassWalk<Cell>& walk, LineProgress& progress);

}  // namespace xgm::aggregation
