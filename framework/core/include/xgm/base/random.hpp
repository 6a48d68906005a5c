// SPDX-License-Identifier: Apache-2.0
// Random numbers that are the same on every machine, which those of <random>'s distributions are
// not.
#pragma once

#include <cstdint>

namespace xgm {

namespace random_bits {

/// Steele, Lea, Flood: Fast splittable pseudorandom number generators (OOPSLA 2014), "SplitMix64".
constexpr std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// The 53 high bits as a number in [0, 1).
constexpr double unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * (1.0 / 9007199254740992.0);
}

}  // namespace random_bits

/// Reproducible random numbers.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t next() {
    const std::uint64_t result = random_bits::mix(state_);
    state_ += 0x9e3779b97f4a7c15ULL;
    return result;
  }
  /// In [low, high).
  constexpr double real(double low, double high) {
    return low + (high - low) * random_bits::unit(next());
  }
  /// In [low, high], both ends included; high - low below 2^32.
  constexpr int integer(int low, int high) {
    const auto count = static_cast<std::uint64_t>(std::int64_t{high} - low + 1);
    return static_cast<int>(low + static_cast<std::int64_t>(next() % count));
  }

 private:
  std::uint64_t state_;
};

}  // namespace xgm
