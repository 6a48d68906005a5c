// SPDX-License-Identifier: Apache-2.0
// How path costs and sums are represented so that nothing overflows.
#pragma once

#include <cstdint>
#include <vector>

#include "plugins/aggregation/path_engine/aggregate.hpp"

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

/// Looks at the penalties of all steps, those of the opposite passes too. Throws Error unless 0 <=
/// P1 <= P2 everywhere.
Bounds find_bounds(const CostVolume& costs, const PenaltyField& penalties,
                   const std::vector<Pass>& passes, bool overcounting_correction);

/// How many fraction bits path costs and sums have. Paths of one step are exact in whole numbers
/// and need none. Means need at least one: as many as 8-bit path costs have room for; if they have
/// none, as many as the 16-bit sums have. Throws Error if even whole sums, cost_weight * max_cost +
/// N * P2, do not stay below kNoMatch.
///
/// The error of means. Let u = 2^-bits. Each step rounds by at most u/2. What is equal for all
/// disparities of a pixel does not matter; so let e be how much the errors of one path cost vary
/// over them. Minima and constants added do not raise it, the mean takes the mean of two such e,
/// and rounding adds at most u: e <= n u after n steps. S sums N paths exactly: differences within
/// a pixel of S are off by at most N n u.
///
/// That is the worst case. Halves are rounded to even, so errors mostly cancel, and paths forget
/// them where P2 cuts in. Census costs of 24 bits with P2 = 96 leave one bit, with P2 = 32 two: the
/// shares of bad pixels in docs/accuracy.md differ from those with eight bits by 0.05 percentage
/// points at most.
int choose_fraction_bits(const Bounds& bounds);

/// Whether finite path costs, C + P2 at most, stay below `infinite`.
bool fits_path_costs(const Bounds& bounds, int fraction_bits, int infinite);

}  // namespace xgm::aggregation
