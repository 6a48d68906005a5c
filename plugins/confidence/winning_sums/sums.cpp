// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "plugins/confidence/winning_sums/winning_sums.hpp"

namespace xgm::winning_sums {

std::optional<int> find_winner(Sums sums, int begin, float disparity) {
  const auto count = static_cast<float>(sums.size());
  const float position = disparity - static_cast<float>(begin);
  if (!(position > -1 && position < count)) return std::nullopt;
  std::optional<int> winner;
  int lowest = kNoMatch;
  for (const float side : {std::floor(position), std::ceil(position)}) {
    if (side < 0 || side >= count) continue;
    const int sum = sums[static_cast<std::size_t>(side)];
    if (sum >= lowest) continue;
    lowest = sum;
    winner = static_cast<int>(side);
  }
  return winner;
}

std::optional<int> runner_up(Sums sums, int winner) {
  const auto at = static_cast<std::size_t>(winner);
  std::uint16_t lowest = kNoMatch;
  for (std::size_t i = 0; i + 1 < at; ++i) lowest = std::min(lowest, sums[i]);
  for (std::size_t i = at + 2; i < sums.size(); ++i) lowest = std::min(lowest, sums[i]);
  if (lowest == kNoMatch) return std::nullopt;
  return lowest;
}

}  // namespace xgm::winning_sums
