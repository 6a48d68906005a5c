// SPDX-License-Identifier: Apache-2.0
// Census bit strings of a row, and their Hamming distances.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace xgm::bench {

inline constexpr int kRowWidth = 1282;
inline constexpr int kRowDisparities = 224;
inline constexpr int kWindowReach = 2;  // 5 x 5: strings of 24 bit

struct RowBuffers {
  static constexpr int kRows = 2 * kWindowReach + 1;
  static constexpr int kStride = 1408;  // with room for the window and a vector on either side
  static constexpr int kPad = 32;

  explicit RowBuffers(std::uint64_t seed);

  alignas(64) std::array<std::array<float, kStride>, kRows> levels;
  alignas(64) std::array<std::uint32_t, kRowWidth + 64> strings;
  /// Of the match row from right to left, so that rising disparities lie behind each other; from
  /// `kRowWidth` on the row's first pixel is repeated.
  alignas(64) std::array<std::uint32_t, kRowWidth + kRowDisparities + 64> mirrored;
  alignas(64) std::array<std::uint8_t, kRowWidth * kRowDisparities> costs;
};

struct RowLoops {
  std::string target;
  /// levels -> strings
  void (*census)(RowBuffers&) = nullptr;
  /// strings, mirrored -> costs, kRowDisparities of each pixel
  void (*hamming)(RowBuffers&) = nullptr;
};

/// Of the plain loops, then of every SIMD target of this processor.
std::vector<RowLoops> row_loops();

}  // namespace xgm::bench
