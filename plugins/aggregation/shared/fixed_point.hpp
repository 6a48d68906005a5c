// SPDX-License-Identifier: Apache-2.0
// How path costs and sums are represented so that nothing overflows.
#pragma once

#include <cstdint>
#include <vector>

#include "plugins/aggregation/shared/aggregate.hpp"

namespace xgm::aggregation {

/// The largest values that occur in an aggregation.
struct Bounds {
  int max_cost = 0;
  int p1 = 0;
  int p2 = 0;
  int paths = 0;        ///< N
  int cost_weight = 1;  ///< how often C is in the sum: N, or 1 with overcounting correction
  bool has_means = false;
};

/// Looks at the penalties of all steps. Throws Error unless 0 <= P1 <= P2 everywhere.
Bounds find_bounds(const CostVolume& costs, const PenaltyField& penalties,
                   const std::vector<Pass>& passes, bool overcounting_correction);

/// Fraction bits. Paths of one step are exact in whole numbers and have none.
struct FractionBits {
  int sums = 0;
  int paths = 0;  ///< at least as many
};

/// The most bits for which nothing overflows 16 bit: the largest sum, cost_weight * max_cost +
/// N * P2, must stay below kNoMatch, and path costs be as fits_path_costs() says. Throws Error if
/// even whole numbers do not fit.
///
/// The error of means. Let u = 2^-paths. Each step rounds by at most u/2. What is equal for all
/// disparities of a pixel does not matter; so let e be how much the errors of one path cost vary
/// over them. Minima and constants added do not raise it, the mean takes the mean of two such e,
/// and rounding adds at most u: e <= n u after n steps. S sums N paths and rounds once per pass:
/// differences within a pixel of S are off by at most N n u + passes * 2^-sums.
///
/// That is the worst case. Halves are rounded to even, so errors mostly cancel, and paths forget
/// them where P2 cuts in; for P1 = 24, P2 = 96, census costs and 16 directions (sums = 5, paths =
/// 8) the tests find 0.03 costs rms. Rounding up was up to three times worse: the best disparity
/// has a term of 0, exact, while the others' terms rise with each step.
FractionBits choose_fraction_bits(const Bounds& bounds);

/// Whether path costs of the given `unit` fit unsigned cells up to `largest_cell`. Infinite is
/// largest_cell - P1, so that P1 can be added; it must be above every finite term, and those
/// reach max_cost + 2 P2. Since there are at least four paths, 16 bit suffice where the sums fit.
bool fits_path_costs(const Bounds& bounds, std::int64_t unit, std::int64_t largest_cell);

}  // namespace xgm::aggregation
