// SPDX-License-Identifier: Apache-2.0
// Runs a pass and its opposite from both ends of the volume at once, half of the threads in each:
// of two threads, neither needs path costs that the other has just written.
#pragma once

#include "plugins/aggregation/shared/line_progress.hpp"
#include "plugins/aggregation/shared/pass_walk.hpp"

namespace xgm::aggregation {

/// `back` is the walk of the opposite pass, from first_line_back() on. Of each line, whichever
/// comes to it first begins the sums, if they are to be begun. Tells `progress` of the lines of
/// both.
template <class Cell>
void run_both_ways(PassWalk<Cell>& there, PassWalk<Cell>& back, bool begin_sums,
                   LineProgress& progress);

/// Both ways have the same bands: the first one back is the last one there, which may have fewer
/// lines than others.
constexpr int first_line_back(int lines) { return bands_of(lines) * kBand - lines; }

}  // namespace xgm::aggregation
