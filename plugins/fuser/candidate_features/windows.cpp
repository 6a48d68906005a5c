// SPDX-License-Identifier: Apache-2.0
#include "plugins/fuser/candidate_features/windows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/fuser/candidate_features/maps.hpp"

namespace xgm::fuser {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Calls visit(y, x) for the pixels of a window, cut off at the border.
template <class Visit>
void each_in_window(cv::Size size, int y, int x, int radius, int stride, const Visit& visit) {
  for (int v = y - radius; v <= y + radius; v += stride) {
    if (v < 0 || v >= size.height) continue;
    for (int u = x - radius; u <= x + radius; u += stride) {
      if (u >= 0 && u < size.width) visit(v, u);
    }
  }
}

}  // namespace

float mean_cost(const cv::Mat1b& costs, int y, int x, int radius) {
  int sum = 0, count = 0;
  each_in_window(costs.size(), y, x, radius, 1, [&](int v, int u) {
    if (costs(v, u) == kNoCost) return;
    sum += costs(v, u);
    ++count;
  });
  return count == 0 ? kUnknown : static_cast<float>(sum) / static_cast<float>(count);
}

float range_of(const cv::Mat1f& values, const cv::Mat1b& valid, int y, int x, int radius) {
  float lowest = std::numeric_limits<float>::infinity(), highest = -lowest;
  each_in_window(values.size(), y, x, radius, 1, [&](int v, int u) {
    const float value = values(v, u);
    if (std::isnan(value) || (!valid.empty() && valid(v, u) == 0)) return;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  });
  return highest >= lowest ? highest - lowest : kUnknown;
}

float deviation(const cv::Mat1f& grey, const Image& image, int y, int x, int radius) {
  float sum = 0, squares = 0, count = 0;
  each_in_window(grey.size(), y, x, radius, 1, [&](int v, int u) {
    if (!image.is_valid(v, u)) return;
    const float level = grey(v, u) - grey(y, x);  // small numbers: squares stay exact enough
    sum += level;
    squares += level * level;
    count += 1;
  });
  const float variance = squares / count - sum / count * (sum / count);
  return std::sqrt(std::max(variance, 0.0F));
}

float gradient(const cv::Mat1f& grey, const Image& image, int y, int x) {
  const int left = std::max(x - 1, 0), right = std::min(x + 1, grey.cols - 1);
  if (!image.is_valid(y, left) || !image.is_valid(y, right)) return kUnknown;
  return std::abs(grey(y, right) - grey(y, left));
}

AlikePixels::AlikePixels(const Image& image, int y, int x, int radius, int stride) {
  const float bound = kAlike * static_cast<float>(image.planes.size());
  each_in_window(image.size(), y, x, radius, stride, [&](int v, int u) {
    if (!image.is_valid(v, u)) return;
    float difference = 0;
    for (const cv::Mat1f& plane : image.planes) difference += std::abs(plane(v, u) - plane(y, x));
    if (difference <= bound) at_[count_++] = {u, v};
  });
}

float AlikePixels::share(const cv::Mat1f& map, float disparity) const {
  int known = 0, same = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const float difference = std::abs(map(at_[i]) - disparity);
    known += std::isnan(difference) ? 0 : 1;
    same += difference < kSame ? 1 : 0;
  }
  return known == 0 ? kUnknown : static_cast<float>(same) / static_cast<float>(known);
}

float AlikePixels::share_known(const cv::Mat1f& map) const {
  int known = 0;
  for (std::size_t i = 0; i < count_; ++i) known += std::isnan(map(at_[i])) ? 0 : 1;
  return static_cast<float>(known) / static_cast<float>(std::max<std::size_t>(count_, 1));
}

}  // namespace xgm::fuser
