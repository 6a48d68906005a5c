// SPDX-License-Identifier: Apache-2.0
// Search ranges per pixel, from files.
#include <cmath>

#include "io/raster.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/pfm.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {
namespace {

constexpr float kLargestDisparity = 1 << 20;

Interval interval_of(float low, float high) {
  if (!std::isfinite(low) || !std::isfinite(high) || low > high) return {};
  return {static_cast<int>(std::floor(low)), static_cast<int>(std::ceil(high)) + 1};
}

void require_pixels(float value, int y, int x, const std::string& file) {
  if (std::isfinite(value) && std::abs(value) > kLargestDisparity) {
    throw Error(file + ": holds " + std::to_string(value) + " at column " + std::to_string(x) +
                ", row " + std::to_string(y) + ", which is no disparity in pixels");
  }
}

}  // namespace

DisparityRange read_range_maps(const std::string& min_file, const std::string& max_file) {
  const cv::Mat1f low = read_pfm(min_file);
  const cv::Mat1f high = read_pfm(max_file);
  if (low.size() != high.size()) {
    throw Error(max_file + ": is " + size_text(high.size()) + " pixels but " + min_file + " is " +
                size_text(low.size()) + "; both maps must have the size of the left image");
  }
  const auto range = DisparityRange::of_pixels(low.size(), [&](int y, int x) {
    require_pixels(low(y, x), y, x, min_file);
    require_pixels(high(y, x), y, x, max_file);
    return interval_of(low(y, x), high(y, x));
  });
  if (range.hull().empty()) {
    throw Error(min_file + ": with " + max_file +
                " leaves no disparity at any pixel; is the order min.pfm,max.pfm?");
  }
  return range;
}

}  // namespace xgm
