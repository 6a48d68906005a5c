// SPDX-License-Identifier: Apache-2.0
// Path-wise aggregation: all passes over a cost volume, forward and backward. What sgm and mgm have
// in common.
#pragma once

#include <cstddef>
#include <vector>

#include "plugins/aggregation/path_engine/pass.hpp"
#include "xgm/stage/aggregation.hpp"

namespace xgm::aggregation {

/// In how many bits path costs are kept. The sums are the same.
enum class PathCostWidth {
  automatic,  ///< 8 if they fit, else 16
  bits8,
  bits16,
};

struct AggregationOptions {
  /// Counts C once, not once per path: S - (N - 1) C.
  bool overcounting_correction = true;
  PathCostWidth width = PathCostWidth::automatic;
  /// Bytes of sums of which the caches keep nothing until the next pass; if they have more, they
  /// are begun past them.
  std::size_t larger_than_caches = std::size_t{128} << 20;
};

/// S(p, d) = sum over all paths of L_r(p, d), with
///   L_r(p, d) = C(p, d) + mean over x of [ min(L_r(p-x, d), L_r(p-x, d+-1) + P1(x),
///               min_i L_r(p-x, i) + P2(x)) - min_i L_r(p-x, i) ],
/// x taken from the steps of the path (Path::steps). The paths are those of `passes` and of their
/// opposites. Subtracting min_i changes S by a constant of the pixel and keeps 0 <= L <= max_cost +
/// P2.
///
/// A disparity outside the range of p - x, or kNoMatch there, is infinitely dear. If p - x lies
/// outside the image or has no finite cell, x does not count; if none counts, L_r(p, d) = C(p, d).
///
/// Paths of one step are computed in whole numbers, exactly. Means are computed with fraction bits
/// (choose_fraction_bits() in fixed_point.hpp).
///
/// Memory beside the two volumes: path costs of thread_count() + 4 lines, twice as many with 16
/// directions; and where penalties vary, classes: two bytes per pixel of each view if there are two
/// (two bytes per step and pixel if more) in passes along columns, those of a few rows otherwise.
///
/// Throws Error if the sums cannot fit 16 bit (or path costs the asked width), or if the penalties
/// do not hold 0 <= P1 <= P2.
XGM_API AggregatedVolume aggregate_paths(const CostVolume& costs, const PenaltyField& penalties,
                                         const std::vector<Pass>& passes,
                                         const AggregationOptions& options, const Context& context);

}  // namespace xgm::aggregation
