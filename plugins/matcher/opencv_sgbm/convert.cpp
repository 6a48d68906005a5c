// SPDX-License-Identifier: Apache-2.0
// Conversions to and from OpenCV's conventions.
#include "plugins/matcher/opencv_sgbm/convert.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace xgm::opencv_sgbm {
namespace {

/// Whether the match image has data where base pixel (x, y) with disparity d is seen.
bool can_match(const Image& match, int y, int x, float d) {
  const int seen = static_cast<int>(std::lround(static_cast<float>(x) - d));
  return 0 <= seen && seen < match.size().width && match.is_valid(y, seen);
}

}  // namespace

Padding skipped_columns(Interval searched) {
  return {std::max(searched.end, 0), std::max(-searched.begin, 0)};
}

cv::Mat to_8bit(const Image& image, Padding padding) {
  std::vector<cv::Mat1b> planes;
  for (const cv::Mat1f& plane : image.planes) {
    cv::Mat1b bytes;
    plane.convertTo(bytes, CV_8U);
    if (!image.valid.empty()) bytes.setTo(0, image.valid == 0);
    planes.push_back(bytes);
  }
  cv::Mat merged, padded;
  cv::merge(planes, merged);
  cv::copyMakeBorder(merged, padded, 0, 0, padding.left, padding.right, cv::BORDER_REPLICATE);
  return padded;
}

DisparityMap from_sixteenths(const cv::Mat1s& sixteenths, const ImagePair& pair,
                             const Meaning& meaning) {
  const cv::Size size = sixteenths.size();
  DisparityMap map(size, Status::out_of_range);
  // Refinement moves disparities by at most half a pixel, beyond the last one too.
  const float highest = static_cast<float>(meaning.asked.end) - 0.5F;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float d = static_cast<float>(sixteenths(y, x)) / 16;
      const bool skipped = x < meaning.skipped.left || x >= size.width - meaning.skipped.right;
      if (!pair.base.is_valid(y, x)) {
        map.invalidate(y, x, Status::masked);
      } else if (sixteenths(y, x) < meaning.searched.begin * 16) {  // OpenCV's "invalid"
        map.invalidate(y, x, skipped ? Status::out_of_range : meaning.rejected);
      } else if (d < highest && can_match(pair.match, y, x, d)) {
        map.set(y, x, d);
      }
    }
  }
  return map;
}

}  // namespace xgm::opencv_sgbm
