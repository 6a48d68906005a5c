// SPDX-License-Identifier: Apache-2.0
// By how much disparities are off, from the grey levels around each pixel.
#pragma once

#include <vector>

#include "plugins/filter/least_squares_matching/warp.hpp"

namespace xgm::least_squares_matching {

struct Window {
  int radius = 3;  ///< px
  float jump = 2;  ///< pixels whose disparity differs by more belong to another surface, px
};

/// What is to be added to a disparity, and the variance of that; {0, infinity} if the window does
/// not tell.
struct Shift {
  float mean, variance;
};

/// Of the pixels of row y, all at once. In a window, base = gain * match(x - d - shift) + offset is
/// solved for gain, offset and shift by least squares of base ~ offset + gain * match - (gain *
/// shift) * slope, each pixel with its own disparity d.
void find_shifts(const cv::Mat1f& disparity, const Warped& warped, const Window& window, int y,
                 std::vector<Shift>& shifts);

}  // namespace xgm::least_squares_matching
