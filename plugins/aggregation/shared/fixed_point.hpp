// SPDX-License-Identifier: Apache-2.0
// How path costs and sums are represented so that nothing overflows.
#pragma once

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

/// Fraction bits of the sums and of the path costs: 0 for paths of one step, which are exact. Means
/// get the most for which the largest possible sum, cost_weight * max_cost + N * P2, stays below
/// kNoMatch. Throws Error if even whole numbers do not fit.
///
/// Halves are rounded up, so that each step adds an error of 0 or half a unit (u = 2^-bits). What
/// is equal for all disparities does not matter; let e be how much the errors of one path cost vary
/// over the disparities of a pixel. Minima and sums with constants do not raise it, the mean takes
/// the mean of two such e, and rounding adds at most u/2: so e <= n u/2 after n steps, and at most
/// N n u/2 in S. This is the worst case; errors are independent and soon forgotten where P2 cuts
/// paths off, so that e is a few u in practice whatever the size of the image (the tests measure
/// it). Rounding one way is better than to the nearest even number: the part of the error that all
/// disparities share drops out, and the rest varies half as much.
int choose_fraction_bits(const Bounds& bounds);

/// Whether path costs fit 8 bit. They are unsigned; infinite is the largest value less P1, and so
/// must be above the largest finite term: max_cost + 2 P2. 16 bit suffice whenever the sums fit,
/// since there are at least four paths.
bool fits_8_bit(const Bounds& bounds);

}  // namespace xgm::aggregation
