// SPDX-License-Identifier: Apache-2.0
// Window minima and maxima are grey erosions and dilations, which OpenCV separates.
#include "plugins/search_range/window_statistics/window_extrema.hpp"

#include <limits>
#include <opencv2/imgproc.hpp>

#include "xgm/base/parallel.hpp"

namespace xgm::search_range {
namespace {

/// The disparities, with `hole` where there is none.
cv::Mat1f with_holes(const DisparityMap& map, float hole) {
  cv::Mat1f filled(map.size());
  for (int y = 0; y < filled.rows; ++y) {
    for (int x = 0; x < filled.cols; ++x) {
      filled(y, x) = map.has_disparity(y, x) ? map.disparity(y, x) : hole;
    }
  }
  return filled;
}

}  // namespace

Proposal window_extrema(const DisparityMap& coarse, int window, int relaxation) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const cv::Mat1b square(window, window, std::uint8_t{1});
  cv::Mat1f low, high;  // holes never win, and pixels outside the image count as holes
  parallel_for(0, 2, [&](int which) {
    if (which == 0)
      cv::erode(with_holes(coarse, kInfinity), low, square);
    else
      cv::dilate(with_holes(coarse, -kInfinity), high, square);
  });

  Proposal proposal(coarse.size());
  parallel_for(0, low.rows, [&](int y) {
    for (int x = 0; x < low.cols; ++x) {
      if (coarse.has_disparity(y, x))
        proposal.set(y, x, relaxed(low(y, x), high(y, x), relaxation));
    }
  });
  return proposal;
}

}  // namespace xgm::search_range
