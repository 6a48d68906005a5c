// SPDX-License-Identifier: Apache-2.0
// Ground truth of a scene, with which maps are compared.
#pragma once

#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace xgm {

/// Maps of one size. A map that is unknown is empty.
struct GroundTruth {
  cv::Mat1f disparity{};     ///< of the left view, px; not finite = unknown
  cv::Mat1f reverse{};       ///< of the right view, with the signs of a reverse map (negative)
  cv::Mat1b non_occluded{};  ///< 255 where a left pixel is also visible in the right image
  cv::Mat1b objects{};       ///< nonzero on moving objects (KITTI's foreground)
  std::vector<std::string> warnings{};  ///< what is doubtful in the files
};

/// The benchmarks' value for "judge this pixel" in masks.
inline constexpr std::uint8_t kJudged = 255;

/// Whether maps are judged by a pixel: it has a true disparity and is not masked out.
inline bool is_judged(const cv::Mat1f& disparity, const cv::Mat1b& mask, int y, int x) {
  return std::isfinite(disparity(y, x)) && (mask.empty() || mask(y, x) == kJudged);
}

}  // namespace xgm
