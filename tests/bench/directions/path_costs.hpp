// SPDX-License-Identifier: Apache-2.0
// The path costs of one direction at a time (the paper's Eq. 3), which the path engine never has
// all at once.
#pragma once

#include "xgm/data/volume.hpp"
#include "xgm/stage/penalty.hpp"

namespace xgm::directions {

/// L_r(p, d), kNoMatch where the cost is kNoMatch. The message of a pixel before it is
///   min(L_r(p-r, d), L_r(p-r, d+-1) + P1, min_i L_r(p-r, i) + P2) - min_i L_r(p-r, i),
/// 0 if that pixel does not exist or cannot match; L_r = C + message. Cell by cell.
Volume<std::uint16_t> path_costs(const CostVolume& costs, const PenaltyField& penalties,
                                 Direction r);

/// Throws Error unless the path costs of all directions, less (N - 1) C, are exactly `sums`, which
/// are those of sgm with the overcounting correction.
void require_sum(const std::vector<Volume<std::uint16_t>>& paths, const CostVolume& costs,
                 const AggregatedVolume& sums);

}  // namespace xgm::directions
