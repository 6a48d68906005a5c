// SPDX-License-Identifier: Apache-2.0
#include "explain/levels.hpp"

#include <algorithm>
#include <cmath>

#include "xgm/base/text.hpp"

namespace xgm::explain {
namespace {

int divided(int n, double scale) { return static_cast<int>(std::ceil(n / scale)); }

int scaled(int x, int from, int to) {
  const auto place = static_cast<std::int64_t>(x) * to / std::max(from, 1);
  return std::clamp(static_cast<int>(place), 0, std::max(to - 1, 0));
}

}  // namespace

cv::Point at_level(cv::Point pixel, cv::Size full, cv::Size size, double scale) {
  if (divided(full.width, scale) == size.width && divided(full.height, scale) == size.height) {
    return {static_cast<int>(pixel.x / scale), static_cast<int>(pixel.y / scale)};
  }
  return {scaled(pixel.x, full.width, size.width), scaled(pixel.y, full.height, size.height)};
}

cv::Point pointed_at(cv::Point pixel, float disparity) {
  const double x = std::floor(pixel.x - static_cast<double>(disparity) + 0.5);
  constexpr double kFar = 1e9;  // beyond every image, and within an int
  return {static_cast<int>(std::clamp(x, -kFar, kFar)), pixel.y};
}

std::string level_name(const Level& level) {
  return level.name.empty() ? "s" + short_number(level.scale) : level.name;
}

}  // namespace xgm::explain
