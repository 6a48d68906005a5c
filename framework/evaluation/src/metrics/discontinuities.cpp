// SPDX-License-Identifier: Apache-2.0
#include "metrics/discontinuities.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "metrics/errors.hpp"

namespace xgm {
namespace {

constexpr float kGap = 2;   // px: eval_disp_gap of Scharstein and Szeliski
constexpr int kWindow = 9;  // px: eval_discont_width

/// False if either is not known: comparisons with NaN are, those with infinity must be.
bool is_jump(float a, float b) {
  return std::isfinite(a) && std::isfinite(b) && std::abs(a - b) > kGap;
}

}  // namespace

cv::Mat1b near_discontinuities(const cv::Mat1f& disparity) {
  cv::Mat1b jumps(disparity.size(), 0);
  for (int y = 0; y < disparity.rows; ++y) {
    for (int x = 0; x < disparity.cols; ++x) {
      if (x > 0 && is_jump(disparity(y, x), disparity(y, x - 1))) {
        jumps(y, x) = jumps(y, x - 1) = kJudged;
      }
      if (y > 0 && is_jump(disparity(y, x), disparity(y - 1, x))) {
        jumps(y, x) = jumps(y - 1, x) = kJudged;
      }
    }
  }
  cv::Mat1b near;
  cv::dilate(jumps, near, cv::getStructuringElement(cv::MORPH_RECT, {kWindow, kWindow}));
  return near;
}

}  // namespace xgm
