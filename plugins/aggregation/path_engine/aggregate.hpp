// SPDX-License-Identifier: Apache-2.0
// Path-wise aggregation, the engine of sgm and mgm: all passes over a cost volume, forward and
// backward. docs/path_engine.md explains it.
#pragma once

#include <cstddef>
#include <vector>

#include "plugins/aggregation/path_engine/pass.hpp"
#include "xgm/stage/aggregation.hpp"

namespace xgm::aggregation {

/// Number of bits of a path cost. The sums do not depend on it.
enum class PathCostWidth {
  automatic,  ///< 8 if all path costs fit, else 16
  bits8,
  bits16,
};

struct AggregationOptions {
  /// Whether S holds C once, not once per path: S - (N - 1) C.
  bool overcounting_correction = true;
  PathCostWidth width = PathCostWidth::automatic;
  /// A sum volume of at least this many bytes does not stay in the caches until the next pass reads
  /// it. Its first values are then written past the caches.
  std::size_t larger_than_caches = std::size_t{128} << 20;
};

/// S(p, d) = sum over all paths of L_r(p, d), with
///   L_r(p, d) = C(p, d) + mean over x of [ min(L_r(p-x, d), L_r(p-x, d+-1) + P1(x),
///               min_i L_r(p-x, i) + P2(x)) - min_i L_r(p-x, i) ],
/// where x runs over the steps of the path (Path::steps), and the paths are those of `passes` and
/// of their opposite passes. Subtracting min_i changes S by a constant per pixel and keeps 0 <= L
/// <= max_cost + P2.
///
/// A disparity that lies outside the range of p - x, or is kNoMatch there, has infinite path cost.
/// If p - x lies outside the image or has no finite path cost, step x is left out of the mean; if
/// all steps are left out, L_r(p, d) = C(p, d).
///
/// Paths of one step are exact in whole numbers. Means are computed with fraction bits
/// (choose_fraction_bits() in fixed_point.hpp).
///
/// Memory in addition to the two volumes: path costs of thread_count() + 4 lines, twice as many
/// with 16 directions. Where penalties vary, their classes are added: two bytes per pixel of each
/// view if there are two classes (two bytes per step and pixel if there are more) for passes along
/// columns, and the same for a few rows only otherwise.
///
/// Throws Error if the sums do not fit 16 bit, if path costs do not fit the requested width, or if
/// penalties violate 0 <= P1 <= P2.
XGM_API AggregatedVolume aggregate_paths(const CostVolume& costs, const PenaltyField& penalties,
                                         const std::vector<Pass>& passes,
                                         const AggregationOptions& options, const Context& context);

}  // namespace xgm::aggregation
