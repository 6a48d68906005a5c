// SPDX-License-Identifier: Apache-2.0
// What is measured in a window around a pixel. Windows are cut off at the border.
#pragma once

#include <array>
#include <opencv2/core.hpp>

#include "xgm/data/image.hpp"

namespace xgm::fuser {

/// Of those that are no kNoCost; NaN if there are none.
float mean_cost(const cv::Mat1b& costs, int y, int x, int radius);
/// Highest less lowest of the values that are not NaN and not masked; NaN if there are none.
float range_of(const cv::Mat1f& values, const cv::Mat1b& valid, int y, int x, int radius);
/// Standard deviation of the grey levels that are valid.
float deviation(const cv::Mat1f& grey, const Image& image, int y, int x, int radius);
/// Of the neighbours to the left and right, grey levels; NaN if one is masked.
float gradient(const cv::Mat1f& grey, const Image& image, int y, int x);

/// The pixels of a window that look like its centre: at most kAlike away from it.
class AlikePixels {
 public:
  static constexpr float kAlike = 10;  ///< grey levels, mean over the planes
  static constexpr float kSame = 1;    ///< px

  /// Every `stride`-th row and column; 11 x 11 pixels at most.
  AlikePixels(const Image& image, int y, int x, int radius, int stride);
  /// The part of those with a disparity in `map` that has nearly this one; NaN if none has any.
  float share(const cv::Mat1f& map, float disparity) const;
  /// The part that has a disparity in `map`.
  float share_known(const cv::Mat1f& map) const;

 private:
  std::array<cv::Point, 121> at_;
  std::size_t count_ = 0;
};

}  // namespace xgm::fuser
