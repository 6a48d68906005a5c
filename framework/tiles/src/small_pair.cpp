// SPDX-License-Identifier: Apache-2.0
#include "small_pair.hpp"

#include <algorithm>

#include "reduced_pair.hpp"
#include "xgm/data/image_parts.hpp"

namespace xgm::tiles {
namespace {

constexpr double kSmallPixels = 1.6e6;

bool is_small(cv::Size size, int scale) {
  return double{1} * size.width * size.height <= kSmallPixels * scale * scale;
}

/// Two bands of whole rows that are small together.
std::vector<cv::Rect> two_bands(cv::Size size, int scale) {
  constexpr int kFewestRows = 256;
  const auto enough = static_cast<int>(kSmallPixels / 2 * scale * scale / size.width);
  const int rows = std::min(std::max(kFewestRows, enough), size.height / 2) / scale * scale;
  const auto band = [&](int middle) {
    return cv::Rect(0, (middle - rows / 2) / scale * scale, size.width, rows);
  };
  return {band(size.height / 4), band(size.height - size.height / 4)};
}

bool has_much_data(const ImagePair& pair) {
  constexpr double kMuch = 0.25;
  const cv::Mat1b& valid = pair.base.valid;
  return valid.empty() || cv::countNonZero(valid) > kMuch * static_cast<double>(valid.total());
}

}  // namespace

SmallPair small_pair(const PairWindows& pair) {
  constexpr int kSmallest = 4;
  const cv::Size size = pair.size();
  int scale = 1;
  while (scale < kSmallest && !is_small(size, scale)) scale *= 2;
  if (!is_small(size, scale) && size.height >= 2 * scale) {
    ImagePair bands = reduced_bands(pair, two_bands(size, scale), scale);
    if (has_much_data(bands)) return {std::move(bands), scale};
    while (!is_small(size, scale)) scale *= 2;
  }
  return {reduced_pair(pair, scale), scale};
}

}  // namespace xgm::tiles
