// SPDX-License-Identifier: Apache-2.0
// Which pixels of a row the other view's disparities point at.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

namespace xgm::lrrl {

/// Whole pixel position nearest to x - disparity, halves to the right: floor(x - disparity + 0.5).
/// Positions outside a row become -1 or width, and so does NaN. Without std::floor, which is a
/// call where there is no instruction for it.
inline int target(int x, float disparity, int width) {
  // The order of the arguments makes a NaN -1.
  const double position =
      std::min<double>(width, std::max(-1.0, x - static_cast<double>(disparity) + 0.5));
  const int truncated = static_cast<int>(position);
  return truncated - (position < truncated ? 1 : 0);
}

/// Row y of the marks: marks[1 + x] becomes 1, for the pixels x of row y of one view, if the line
/// of sight through x meets the disparity function of the `other` view, else 0: target(q, d(q)) = x
/// for some pixel q, or x lies between the targets of q and q + 1 where both belong to one surface
/// (their disparities differ by at most `step`). marks[0] and marks[1 + width] have no meaning.
void mark_pointed_at(const cv::Mat1f& other, int y, double step, std::uint8_t* marks);

}  // namespace xgm::lrrl
