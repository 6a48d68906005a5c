// SPDX-License-Identifier: Apache-2.0
// One pixel's cells of a volume, and what stands out among them.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "xgm/data/volume.hpp"
#include "xgm/evaluation/explain.hpp"

namespace xgm::explain {

/// Puts the pixel's cells, divided by `units_per_cost`, into `curve`, one per disparity of the
/// match's range; the range grows, and its other curve with it, if there are cells outside.
template <class Cell>
void take_cells(const Volume<Cell>& volume, float units_per_cost, MatchExplanation& match,
                std::vector<float> MatchExplanation::*curve);

/// The curve that was decided on: the sums, or the costs of a matcher that sums nothing up.
const std::vector<float>& decisive(const MatchExplanation& match);

/// Index of the lowest number, the first of equal ones; -1 if there is none.
int lowest(const std::vector<float>& curve);

/// Index of the lowest local minimum that is not `winner` or next to it, the first of equal ones;
/// -1 if there is none. A flat bottom counts once, by its first cell, and not at all if the winner
/// lies in it. Cells without match, and the ends, are higher than everything.
int runner_up(const std::vector<float>& curve, int winner);

/// Cost and sum of a disparity; NaN outside of the curves.
Candidate candidate(const MatchExplanation& match, int disparity);

/// Fills in winner (keeping what was chosen) and runner-up.
void find_candidates(MatchExplanation& match);

}  // namespace xgm::explain
