// SPDX-License-Identifier: Apache-2.0
// Fixed-point representation of path costs and sums, chosen so that nothing overflows.
#pragma once

#include <cstdint>
#include <vector>

#include "plugins/aggregation/path_engine/aggregate.hpp"

namespace xgm::aggregation {

/// Upper bounds of the values in an aggregation.
struct Bounds {
  int max_cost = 0;
  int p1 = 0;
  int p2 = 0;
  int paths = 0;           ///< N, the number of directions
  int cost_weight = 1;     ///< times C is in S: N, or 1 with overcounting correction
  bool has_means = false;  ///< whether a path has two steps
};

/// Examines the penalties of all steps, including those of the opposite passes. Throws Error unless
/// 0 <= P1 <= P2 everywhere.
Bounds find_bounds(const CostVolume& costs, const PenaltyField& penalties,
                   const std::vector<Pass>& passes, bool overcounting_correction);

/// Number of fraction bits of path costs and sums. Paths of one step are exact in whole numbers and
/// get none. Means get as many fraction bits as 8-bit path costs have room for or, if these have no
/// room, as many as 16-bit sums have room for. Throws Error if the largest sum in whole numbers,
/// cost_weight * max_cost + N * P2, is not below kNoMatch.
///
/// The error of means. Let u = 2^-bits. Each step rounds by at most u/2. An error that is equal for
/// all disparities of a pixel does not matter, so let e be the spread of the errors of one path
/// over the disparities. Minima and added constants do not increase e, a mean has the mean of the
/// two e, and rounding adds at most u: after n steps, e <= n u. S sums N paths exactly, so
/// differences between the sums of one pixel are off by at most N n u.
///
/// That is the worst case. Halves are rounded to even, so most errors cancel, and a path forgets
/// earlier errors where it takes the P2 term. Census costs of 24 bits leave one fraction bit with
/// P2 = 96 and two with P2 = 32. The shares of bad pixels in docs/accuracy.md differ from those
/// with eight fraction bits by 0.05 percentage points at most.
int choose_fraction_bits(const Bounds& bounds);

/// Whether all finite path costs, at most max_cost + P2, stay below `infinite`.
bool fits_path_costs(const Bounds& bounds, int fraction_bits, int infinite);

}  // namespace xgm::aggregation
