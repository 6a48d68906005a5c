// SPDX-License-Identifier: Apache-2.0
// Random numbers of normal distribution.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "xgm/base/random.hpp"

namespace xgm::geo {

/// Mean 0, standard deviation 1; one number per key. Box, Muller: A note on the generation of
/// random normal deviates (Annals of Mathematical Statistics 29, 1958).
inline double normal_noise(std::uint64_t key) {
  using random_bits::mix;
  using random_bits::unit;
  const double u = 1 - unit(mix(key)), v = unit(mix(key ^ 0x5bd1e995));
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

}  // namespace xgm::geo
