// SPDX-License-Identifier: Apache-2.0
// What the fastest path steps need: buffers that stay in the first-level cache, and loops by hand.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace xgm::bench {

inline constexpr int kDisparities = 256;
inline constexpr int kMaxPaths = 4;
inline constexpr int kPixels = 4;   ///< that are gone through in a ring
inline constexpr int kRounds = 16;  ///< of the ring, in one call of a kernel

/// Path costs of a pixel with an unreachable neighbour at both ends.
template <class Cell>
struct PathSlice {
  static constexpr int kPad = static_cast<int>(64 / sizeof(Cell));
  alignas(64) std::array<Cell, std::size_t{kPad + kDisparities + kPad}> cells;
  Cell minimum;

  Cell* at(int d) { return cells.data() + kPad + d; }
};

/// Everything that a step reads or writes.
template <class Cell>
struct PathBuffers {
  explicit PathBuffers(std::uint64_t seed);

  Cell p1 = 24, p2 = 96;
  alignas(64) std::array<std::array<std::uint8_t, kDisparities>, kPixels> costs;
  alignas(64) std::array<std::array<std::uint16_t, kDisparities>, kPixels> sums;
  /// Of the row in work and the one above, which change places in each round.
  std::array<std::array<std::array<PathSlice<Cell>, kPixels>, kMaxPaths>, 2> paths;
};

extern template struct PathBuffers<std::uint8_t>;
extern template struct PathBuffers<std::uint16_t>;

template <class Cell>
using PathLoop = void (*)(PathBuffers<Cell>&);

/// L = C + term, with the term of SGM's Eq. 3 less its least, or MGM's mean of two, halves to even;
/// sums += term. Loops of kRounds x kPixels pixels with one path at a time, or four interleaved.
struct PathLoops {
  std::string target;
  PathLoop<std::uint8_t> sgm8_one = nullptr, sgm8_four = nullptr;
  PathLoop<std::uint8_t> mgm8_one = nullptr, mgm8_four = nullptr;
  PathLoop<std::uint16_t> sgm16_one = nullptr, sgm16_four = nullptr;
  PathLoop<std::uint16_t> mgm16_one = nullptr, mgm16_four = nullptr;
};

/// Of the plain loops, then of every SIMD target of this processor.
std::vector<PathLoops> path_loops();

}  // namespace xgm::bench
