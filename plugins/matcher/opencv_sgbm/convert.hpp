// SPDX-License-Identifier: Apache-2.0
// Between our images and maps and those of cv::StereoSGBM.
#pragma once

#include <opencv2/core.hpp>

#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/image.hpp"

namespace xgm::opencv_sgbm {

/// Columns added to both images so that StereoSGBM, which skips base pixels of which some
/// disparity leaves the match image, matches all of the base image.
struct Padding {
  int left = 0;
  int right = 0;
};

/// What StereoSGBM would skip when it searches `searched`.
Padding skipped_columns(Interval searched);

/// 8 bits, one or three channels, rounded; border columns repeated; masked pixels black.
cv::Mat to_8bit(const Image& image, Padding padding);

/// What StereoSGBM's answers mean.
struct Meaning {
  Interval searched;  ///< what StereoSGBM was asked: a multiple of 16 disparities
  Interval asked;     ///< what we were asked
  Padding skipped;    ///< columns of the unpadded image that it did not match
  Status rejected;    ///< status of pixels whose disparity it took away
};

/// Sixteenths of a pixel become pixels. Disparities outside the asked range, or of which the match
/// image has no data, become out_of_range; masked base pixels masked.
DisparityMap from_sixteenths(const cv::Mat1s& sixteenths, const ImagePair& pair,
                             const Meaning& meaning);

}  // namespace xgm::opencv_sgbm
