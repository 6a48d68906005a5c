// SPDX-License-Identifier: Apache-2.0
// From differences in grey levels to 8-bit costs: mean over the channels, truncated, rounded.
#pragma once

#include <algorithm>
#include <cstdint>

#include "plugins/cost/shared/candidates.hpp"

namespace xgm::cost {

/// Writes the cost of each candidate: difference(channel, i), in grey levels and not negative, is
/// that of base pixel c.x and element i of the mirrored match row. Half a level is rounded up.
template <class Difference>
void fill_truncated_mean(const Candidates& c, int channels, float truncation,
                         Difference difference) {
  for (int i = 0; i < c.count; ++i) {
    float sum = 0;
    for (int channel = 0; channel < channels; ++channel) sum += difference(channel, c.first + i);
    // The order of min's arguments makes a NaN cost the truncation.
    const float mean = std::min(truncation, sum / static_cast<float>(channels));
    c.cells[i] = static_cast<std::uint8_t>(mean + 0.5F);
  }
}

}  // namespace xgm::cost
