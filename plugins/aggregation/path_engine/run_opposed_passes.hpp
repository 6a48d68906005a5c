// SPDX-License-Identifier: Apache-2.0
// Runs a pass and its opposite from both ends of the volume at once, half of the threads in each:
// of two threads, neither needs path costs that the other has just written.
#pragma once

#include "plugins/aggregation/path_engine/line_progress.hpp"
#include "plugins/aggregation/path_engine/pass_walk.hpp"

namespace xgm::aggregation {

/// `backward` is the walk of the opposite pass, from first_backward_line() on. Of each line,
/// whichever comes to it first begins the sums, if they are to be begun. Tells `progress` of the
/// lines of both.
template <class Cell>
void run_opposed_passes(PassWalk<Cell>& forward, PassWalk<Cell>& backward, bool begin_sums,
                        LineProgress& progress);

/// Both passes have the same bands: the first one backward is the last one forward, which may have
/// fewer lines than others.
constexpr int first_backward_line(int lines) { return bands_of(lines) * kBand - lines; }

}  // namespace xgm::aggregation
