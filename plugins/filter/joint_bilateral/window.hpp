// SPDX-License-Identifier: Apache-2.0
// The filter at single pixels, plainly: the reference of the kernel, and what it leaves over.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "plugins/filter/joint_bilateral/weights.hpp"

namespace xgm::joint_bilateral {

/// What the filter sees.
struct Scene {
  cv::Mat1f disparity;           ///< NaN where there is no vote
  std::vector<cv::Mat1f> guide;  ///< planes of the base image
  const Weights& weights;
};

enum class Mode { median, mean };

/// The weighted median or mean of the votes for each pixel of row y that has a disparity, written
/// to filtered[x]. Pixels without a disparity, or for which nobody votes, keep what is there.
/// Dispatched: the same bits for every SIMD target.
void filter_row(const Scene& scene, Mode mode, int y, float* filtered);

/// The same for some of the columns, without vectors.
void plain_filter(const Scene& scene, Mode mode, int y, cv::Range columns, float* filtered);

}  // namespace xgm::joint_bilateral
