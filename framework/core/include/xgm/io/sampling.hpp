// SPDX-License-Identifier: Apache-2.0
// Fewer pixels of large images, for pictures: files and browsers have limits, and so has memory.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

#include "xgm/base/export.hpp"

namespace xgm {

/// Every stride-th pixel of an image, from the middle of its stride: pictures show real values of
/// fewer pixels rather than means over edges.
struct XGM_API Sampling {
  cv::Size full;
  int stride = 1;

  /// Longest side of a picture. PNG files may have 1000000 px, JPEG 65500, what browsers draw on
  /// 16384.
  static constexpr int kMaxSide = 16384;
  /// The smallest stride that leaves at most `pixels` pixels, and kMaxSide to each side.
  static Sampling within(cv::Size full, double pixels);
  /// For pictures in files of their own.
  static Sampling of_picture(cv::Size full);

  cv::Size shown() const { return {shorter(full.width), shorter(full.height)}; }
  cv::Point at(int x, int y) const { return {middle(x, full.width), middle(y, full.height)}; }

 private:
  int shorter(int n) const { return (n + stride - 1) / stride; }
  int middle(int i, int n) const { return std::min(i * stride + stride / 2, n - 1); }
};

template <class Pixel>
cv::Mat_<Pixel> sampled(const cv::Mat_<Pixel>& map, const Sampling& sampling) {
  cv::Mat_<Pixel> result(sampling.shown());
  for (int y = 0; y < result.rows; ++y) {
    for (int x = 0; x < result.cols; ++x) result(y, x) = map(sampling.at(x, y));
  }
  return result;
}

}  // namespace xgm
