// SPDX-License-Identifier: Apache-2.0
#include "explain/levels.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace xgm::explain {
namespace {

/// How often `full` is halved to give `level`; -1 if never.
int halvings(cv::Size full, cv::Size level) {
  for (int count = 0;; ++count) {
    if (full == level) return count;
    if (full.width <= 1 && full.height <= 1) return -1;
    full = {full.width / 2 + full.width % 2, full.height / 2 + full.height % 2};
  }
}

int scaled(int x, int from, int to) {
  const auto place = static_cast<std::int64_t>(x) * to / std::max(from, 1);
  return std::clamp(static_cast<int>(place), 0, std::max(to - 1, 0));
}

}  // namespace

double scale_of(cv::Size full, cv::Size level) {
  const int count = halvings(full, level);
  if (count >= 0) return std::ldexp(1.0, count);
  return static_cast<double>(full.width) / std::max(level.width, 1);
}

cv::Point at_level(cv::Point pixel, cv::Size full, cv::Size level) {
  const int count = halvings(full, level);
  if (count >= 0) return {pixel.x >> count, pixel.y >> count};
  return {scaled(pixel.x, full.width, level.width), scaled(pixel.y, full.height, level.height)};
}

cv::Point pointed_at(cv::Point pixel, float disparity) {
  const double x = std::floor(pixel.x - static_cast<double>(disparity) + 0.5);
  constexpr double kFar = 1e9;  // beyond every image, and within an int
  return {static_cast<int>(std::clamp(x, -kFar, kFar)), pixel.y};
}

std::string level_name(double scale) {
  std::ostringstream name;
  name.precision(3);
  name << 's' << scale;
  return name.str();
}

bool in_reverse_scope(const std::string& stage_path) {
  return ("." + stage_path + ".").find(".reverse.") != std::string::npos;
}

}  // namespace xgm::explain
