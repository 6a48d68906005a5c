// SPDX-License-Identifier: Apache-2.0
#include "plugins/consistency/lrrl/sight_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace xgm::lrrl {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// floor(x - disparity + 0.5) in doubles, which are exact here, kept within [-1, width]. A cast
/// instead of std::floor, so that compilers make vectors of it.
inline int nearest(int x, float disparity, int width) {
  double position = x - static_cast<double>(disparity) + 0.5;
  position = position > -1 ? position : -1;  // NaN, too
  position = position < width ? position : width;
  const int truncated = static_cast<int>(position);
  return truncated - (position < truncated ? 1 : 0);
}

}  // namespace

SightLines::SightLines(int width)
    : disparities_(static_cast<std::size_t>(width) + 2, kNone),
      targets_(static_cast<std::size_t>(width)),
      met_(static_cast<std::size_t>(width) + 2) {}

void SightLines::load(const float* disparities, double step) {
  const int count = width();
  std::copy_n(disparities, count, disparities_.data() + 1);
  int* const targets = targets_.data();
  for (int q = 0; q < count; ++q) targets[q] = nearest(q, disparities[q], count);

  std::uint8_t* const met = met_.data() + 1;
  std::fill(met_.begin(), met_.end(), std::uint8_t{0});
  for (int q = 0; q < count; ++q) met[targets[q]] = 1;
  for (int q = 1; q < count; ++q) {
    const auto [first, last] = std::minmax(targets[q - 1], targets[q]);
    if (last - first < 2) continue;  // nearly always: there is nothing between them
    const double jump = static_cast<double>(disparities[q]) - disparities[q - 1];
    if (std::abs(jump) <= step) std::fill(met + first, met + last, std::uint8_t{1});
  }
}

}  // namespace xgm::lrrl
