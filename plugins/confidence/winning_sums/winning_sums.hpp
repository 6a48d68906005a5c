// SPDX-License-Identifier: Apache-2.0
// What confidences that read sums share: where the winner of each pixel stands among its sums.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "xgm/plugin.hpp"

namespace xgm::winning_sums {

using Sums = std::span<const std::uint16_t>;

constexpr std::uint16_t kNoMatch = AggregatedVolume::kNoMatch;

/// The index of the sum that `disparity` was selected by: that of the whole disparity or, if it has
/// been refined by up to half a pixel, of the lower one of the two beside it. `begin` is the
/// disparity of the first sum. None if neither can match.
std::optional<int> find_winner(Sums sums, int begin, float disparity);

/// The lowest of the sums that are not beside the winner; none if nothing else can match. Sums
/// beside it are part of the same minimum.
std::optional<int> runner_up(Sums sums, int winner);

/// x / (x + half): any measure of 0 and more as a number from 0 to 1 in the same order.
inline float saturated(double x, double half) { return static_cast<float>(x / (x + half)); }

/// measure(sums, winner), 0 to 1, of each matched pixel, NaN of the others.
template <class Measure>
cv::Mat1f of_winners(const Evidence& evidence, const Measure& measure) {
  const DisparityMap& map = evidence.map;
  const AggregatedVolume& sums = *evidence.sums;
  cv::Mat1f confidence(map.size(), std::numeric_limits<float>::quiet_NaN());
  parallel_for(0, map.size().height, [&](int y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (map.at(y, x) != Status::matched) continue;
      const Sums cells = sums.cells(y, x);
      const auto winner = find_winner(cells, sums.shape().begin(y, x), map.disparity(y, x));
      if (winner) confidence(y, x) = measure(cells, *winner);
    }
  });
  return confidence;
}

}  // namespace xgm::winning_sums
