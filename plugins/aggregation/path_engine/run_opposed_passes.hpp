// SPDX-License-Identifier: Apache-2.0
// Runs the forward and the backward pass from both ends of the volume at once, half of the threads
// in each. With two threads, neither reads path costs that the other has just written.
#pragma once

#include "plugins/aggregation/path_engine/line_progress.hpp"
#include "plugins/aggregation/path_engine/pass_walk.hpp"

namespace xgm::aggregation {

/// `backward` is the walk of the opposite pass; its lines are numbered from first_backward_line()
/// on. If `begin_sums`, the pass that comes first to a line begins its sums; otherwise both add to
/// them. Reports the lines of both passes to `progress`.
template <class Cell>
void run_opposed_passes(PassWalk<Cell>& forward, PassWalk<Cell>& backward, bool begin_sums,
                        LineProgress& progress);

/// Both passes have the same bands. The first band of the backward pass is the last band of the
/// forward pass, which may have fewer lines than the others.
constexpr int first_backward_line(int lines) { return bands_of(lines) * kBand - lines; }

}  // namespace xgm::aggregation
