// SPDX-License-Identifier: Apache-2.0
// The inner step: extends one path by one pixel, for all its disparities at once. Plain loops over
// contiguous cells, without branches, that compilers turn into vector code.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "xgm/data/volume.hpp"

namespace xgm::aggregation {

/// The same P1 and P2 for all disparities.
template <class Cell>
struct SamePenalties {
  Cell p1, p2;
  Cell small(int) const { return p1; }
  Cell large(int) const { return p2; }
};

/// P1 and P2 of each disparity.
template <class Cell>
struct CellPenalties {
  const Cell* p1;
  const Cell* p2;
  Cell small(int i) const { return p1[i]; }
  Cell large(int i) const { return p2[i]; }
};

/// What a path brings to p from p - x: the minimum of Eq. 3 less min_i L(p - x, i), so at most P2.
/// `previous` holds L(p - x, d) for the disparities of p, and one more on either side.
template <class Cell, class Penalties>
struct Term {
  const Cell* previous;
  Cell least;
  Penalties penalties;

  Cell operator()(int i) const {
    const Cell beside = std::min(previous[i - 1], previous[i + 1]);
    const auto near = static_cast<Cell>(beside + penalties.small(i));
    const auto far = static_cast<Cell>(least + penalties.large(i));
    return static_cast<Cell>(std::min(std::min(previous[i], near), far) - least);
  }
};

/// The mean of two terms, halves rounded to even: always up or down, errors would add up.
template <class Cell, class Penalties>
struct MeanTerm {
  Term<Cell, Penalties> first, second;
  Cell operator()(int i) const {
    const auto twice = static_cast<Cell>(first(i) + second(i));
    const auto down = static_cast<Cell>(twice >> 1);
    return static_cast<Cell>(down + (twice & down & 1));
  }
};

/// A path that starts here.
template <class Cell>
struct NoTerm {
  Cell operator()(int) const { return 0; }
};

/// Sum of the terms of a pass: up to 8 of 8 bit, or of 16 bit.
template <class Cell>
using PassSum = std::conditional_t<sizeof(Cell) == 1, std::uint16_t, std::uint32_t>;

/// L = unit * C + term, infinite where C is kNoMatch; adds the term to `sum`. `unit` is a cost of
/// one, 1 for 8-bit cells. Returns the least L, `infinite` if there is no finite one.
template <class Cell, class AnyTerm>
Cell extend(AnyTerm term, const std::uint8_t* __restrict cost, int count, Cell unit, Cell infinite,
            Cell* __restrict path, PassSum<Cell>* __restrict sum) {
  constexpr auto kNoMatch = Volume<std::uint8_t>::kNoMatch;
  Cell least = infinite;
  for (int i = 0; i < count; ++i) {
    const Cell brought = term(i);
    Cell own = cost[i];
    if constexpr (sizeof(Cell) > 1) own = static_cast<Cell>(own * unit);
    const auto finite = static_cast<Cell>(own + brought);
    const Cell extended = cost[i] == kNoMatch ? infinite : finite;
    path[i] = extended;
    least = std::min(least, extended);
    sum[i] = static_cast<PassSum<Cell>>(sum[i] + brought);
  }
  return least;
}

/// sum / 2^bits, halves rounded up.
template <class Sum>
std::uint16_t rounded(Sum sum, int bits) {
  return static_cast<std::uint16_t>((sum + ((1u << bits) >> 1)) >> bits);
}

/// S = cost_unit * C + sum / 2^extra_bits, kNoMatch where C is.
template <class Sum>
void write_sums(const std::uint8_t* __restrict cost, const Sum* __restrict sum, int count,
                int extra_bits, std::uint16_t cost_unit, std::uint16_t* __restrict sums) {
  for (int i = 0; i < count; ++i) {
    const auto finite =
        static_cast<std::uint16_t>(cost_unit * cost[i] + rounded(sum[i], extra_bits));
    sums[i] = cost[i] == Volume<std::uint8_t>::kNoMatch ? AggregatedVolume::kNoMatch : finite;
  }
}

/// S = S + sum / 2^extra_bits, but kNoMatch remains.
template <class Sum>
void add_sums(const Sum* __restrict sum, int count, int extra_bits,
              std::uint16_t* __restrict sums) {
  for (int i = 0; i < count; ++i) {
    const auto finite = static_cast<std::uint16_t>(sums[i] + rounded(sum[i], extra_bits));
    sums[i] = sums[i] == AggregatedVolume::kNoMatch ? AggregatedVolume::kNoMatch : finite;
  }
}

}  // namespace xgm::aggregation
