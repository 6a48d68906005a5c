// SPDX-License-Identifier: Apache-2.0
// The match image as a disparity map lays it over the base image.
#pragma once

#include "xgm/data/disparity_map.hpp"
#include "xgm/data/image.hpp"

namespace xgm::least_squares_matching {

struct Warped {
  cv::Mat1f base;   ///< grey levels of the base image
  cv::Mat1f match;  ///< those of the match image at x - disparity; 0 where `seen` is not set
  cv::Mat1f slope;  ///< their derivative along the row, grey levels per px
  cv::Mat1f seen;   ///< 1 where a pixel is matched and both images have data around it, else 0
};

/// Cubic convolution (Keys 1981) along the row: linear interpolation would blur one image alone,
/// by an amount that depends on the fraction of the disparity.
Warped warp(const DisparityMap& map, const ImagePair& pair);

}  // namespace xgm::least_squares_matching
