// SPDX-License-Identifier: Apache-2.0
// The path steps as plain loops: the reference of those by hand, and what the compiler alone makes
// of them.
#pragma once

#include <algorithm>

#include "bench/roofline/path_kernels.hpp"

namespace xgm::bench {

/// Adds without going beyond the largest cell, as vector instructions do.
template <class Cell>
Cell add_up_to_largest(Cell a, Cell b) {
  const auto sum = static_cast<Cell>(a + b);
  return sum < a ? static_cast<Cell>(-1) : sum;
}

template <class Cell>
Cell plain_term(const Cell* previous, Cell minimum, Cell p1, Cell p2) {
  const Cell near = add_up_to_largest(std::min(previous[-1], previous[1]), p1);
  const Cell far = add_up_to_largest(minimum, p2);
  return static_cast<Cell>(std::min(std::min(previous[0], near), far) - minimum);
}

/// The mean, halves to even.
template <class Cell>
Cell plain_mean(Cell a, Cell b) {
  const int twice = a + b;
  const int down = twice >> 1;
  return static_cast<Cell>(down + (twice & down & 1));
}

template <class Cell, bool kTwoTerms>
void plain_step(PathBuffers<Cell>& buffers, int row, int path, int pixel) {
  auto& slices = buffers.paths[static_cast<std::size_t>(row)][static_cast<std::size_t>(path)];
  auto& other = buffers.paths[static_cast<std::size_t>(1 - row)][static_cast<std::size_t>(path)];
  const auto here = static_cast<std::size_t>(pixel);
  PathSlice<Cell>& left = slices[static_cast<std::size_t>((pixel + kPixels - 1) % kPixels)];
  PathSlice<Cell>& above = other[here];
  PathSlice<Cell>& own = slices[here];
  const std::uint8_t* cost = buffers.costs[here].data();
  std::uint16_t* sum = buffers.sums[here].data();
  auto minimum = static_cast<Cell>(-1);
  for (int d = 0; d < kDisparities; ++d) {
    Cell term = plain_term(left.at(d), left.minimum, buffers.p1, buffers.p2);
    if constexpr (kTwoTerms) {
      term = plain_mean(term, plain_term(above.at(d), above.minimum, buffers.p1, buffers.p2));
    }
    const Cell extended = add_up_to_largest(static_cast<Cell>(cost[d]), term);
    *own.at(d) = extended;
    minimum = std::min(minimum, extended);
    sum[d] = static_cast<std::uint16_t>(sum[d] + term);
  }
  own.minimum = minimum;
}

template <class Cell, bool kTwoTerms, int kPaths>
void plain_loop(PathBuffers<Cell>& buffers) {
  for (int round = 0; round < kRounds; ++round) {
    for (int pixel = 0; pixel < kPixels; ++pixel) {
      for (int path = 0; path < kPaths; ++path) {
        plain_step<Cell, kTwoTerms>(buffers, round % 2, path, pixel);
      }
    }
  }
}

}  // namespace xgm::bench
