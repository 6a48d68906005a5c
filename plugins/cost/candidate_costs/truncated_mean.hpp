// SPDX-License-Identifier: Apache-2.0
// From differences in grey levels to 8-bit costs: mean over the channels, truncated, rounded.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "plugins/cost/candidate_costs/candidates.hpp"
#include "xgm/config/parameters.hpp"

namespace xgm::cost {

/// What costs of this kind can be told.
struct Truncation {
  int truncation = 64;

  static void describe(Truncation& p, ParameterSet& set) {
    set.add("truncation", p.truncation, "Largest cost; greater differences count as this one.")
        .unit("grey levels")
        .range(1, 254);
  }
};

/// Writes row y of the volume. A difference has kNumbers planes per channel and gives, from the
/// numbers of a base and a match pixel, Difference::of(a, b) in grey levels, not negative. Half a
/// level is rounded up. What vectors do is measured by this; see truncated_mean-inl.hpp.
template <class Difference>
void truncated_mean_plain(const RowPair<float>& rows, int y, float truncation, CostVolume& costs) {
  using Numbers = std::array<float, Difference::kNumbers>;
  const auto numbers = [](const PixelRow<float>& row, int channel, int x) {
    Numbers result;
    int plane = channel * Difference::kNumbers;
    for (float& number : result) number = row.plane(plane++)[x];
    return result;
  };
  const VolumeShape& shape = costs.shape();
  for (int x = 0; x < shape.width(); ++x) {
    const int first = RowPair<float>::first(shape, y, x);
    std::uint8_t* const cells = costs.at(y, x);
    for (int i = 0; i < shape.room(y, x); ++i) {
      float sum = 0;
      for (int c = 0; c < rows.channels; ++c) {
        sum += Difference::of(numbers(rows.base, c, x), numbers(rows.match, c, first + i));
      }
      // The order of min's arguments makes a NaN cost the truncation.
      const float mean = std::min(truncation, sum / static_cast<float>(rows.channels));
      const bool absent = rows.match.absent()[first + i] != 0;
      cells[i] = absent ? CostVolume::kNoMatch : static_cast<std::uint8_t>(mean + 0.5F);
    }
  }
}

}  // namespace xgm::cost
