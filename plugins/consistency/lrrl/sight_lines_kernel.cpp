// SPDX-License-Identifier: Apache-2.0
// What is done for each pixel of a row, in loops that compilers make vectors of. They are compiled
// for each SIMD target; what they say does not depend on that.
#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/consistency/lrrl/sight_lines.hpp"
#include "xgm/base/simd_dispatch.hpp"
#include "xgm/data/disparity_map.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/consistency/lrrl/sight_lines_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace xgm::lrrl::HWY_NAMESPACE {

/// floor(x - disparity + 0.5) in doubles, which are exact here, kept within [-1, width]. A cast
/// instead of std::floor, so that compilers make vectors of it.
inline int nearest(int x, float disparity, int width) {
  double position = x - static_cast<double>(disparity) + 0.5;
  position = position > -1 ? position : -1;  // NaN, too
  position = position < width ? position : width;
  const int truncated = static_cast<int>(position);
  return truncated - (position < truncated ? 1 : 0);
}

void find_targets(const float* __restrict disparities, int width, int* __restrict targets) {
  for (int x = 0; x < width; ++x) targets[x] = nearest(x, disparities[x], width);
}

void check_row(const SightLines& row, const SightLines& other, double threshold,
               const std::uint8_t* __restrict states, float* __restrict disparities,
               std::uint8_t* __restrict reasons) {
  const float* const own = row.disparities();
  const float* const theirs = other.disparities();
  const int* const targets = row.targets();
  const std::uint8_t* const met = other.met();
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  for (int x = 0; x < row.width(); ++x) {
    // NaN, of a pixel without a disparity or for a target outside, compares false.
    const double round_trip = static_cast<double>(own[x]) + theirs[targets[x]];
    const bool agrees = std::abs(round_trip) <= threshold;
    const bool stays = agrees | !has_disparity(static_cast<Status>(states[x]));
    const Status reason = met[x] != 0 ? Status::mismatched : Status::occluded;
    disparities[x] = stays ? own[x] : kNone;
    reasons[x] = stays ? states[x] : static_cast<std::uint8_t>(reason);
  }
}

}  // namespace xgm::lrrl::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace xgm::lrrl {

HWY_EXPORT(find_targets);
HWY_EXPORT(check_row);

SightLines::SightLines(int width)
    : disparities_(static_cast<std::size_t>(width) + 2, std::numeric_limits<float>::quiet_NaN()),
      targets_(static_cast<std::size_t>(width)),
      met_(static_cast<std::size_t>(width) + 2) {}

void SightLines::load(const float* disparities, double step) {
  const int count = width();
  std::copy_n(disparities, count, disparities_.data() + 1);
  int* const targets = targets_.data();
  XGM_SIMD_DISPATCH(find_targets)(disparities, count, targets);

  std::uint8_t* const met = met_.data() + 1;
  std::fill(met_.begin(), met_.end(), std::uint8_t{0});
  if (count > 0) met[targets[0]] = 1;
  for (int q = 1; q < count; ++q) {
    met[targets[q]] = 1;
    const auto [first, last] = std::minmax(targets[q - 1], targets[q]);
    if (last - first < 2) continue;  // nearly always: there is nothing between them
    const double jump = static_cast<double>(disparities[q]) - disparities[q - 1];
    if (std::abs(jump) <= step) std::fill(met + first, met + last, std::uint8_t{1});
  }
}

void check(const SightLines& row, const SightLines& other, double threshold,
           const std::uint8_t* states, float* disparities, std::uint8_t* reasons) {
  XGM_SIMD_DISPATCH(check_row)(row, other, threshold, states, disparities, reasons);
}

}  // namespace xgm::lrrl
#endif
