// SPDX-License-Identifier: Apache-2.0
// How far a disparity map is from the truth: the figures of the paper's section 4.2, as defined by
// the Middlebury stereo evaluation, version 3.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"

namespace xgm {

/// Shares of the judged pixels at one threshold, 0 to 1.
struct ThresholdScore {
  double delta = 1;  ///< px
  double bad = 0;    ///< has a disparity, but more than delta off
  double total = 0;  ///< bad + invalid
};

struct Evaluation {
  std::int64_t judged = 0;         ///< pixels that have a true disparity and are not masked out
  double invalid = 0;              ///< share of them without a disparity, 0 to 1
  double average_error = 0;        ///< mean |d - truth| where both exist, px; NaN if nowhere
  std::vector<ThresholdScore> at;  ///< one per threshold asked for, in that order
};

/// Compares `map` with `truth` (px, not finite = none), only where `mask` is 255 (the benchmarks'
/// value for "not occluded") if there is one. Throws Error if the sizes differ or nothing is left
/// to judge.
XGM_API Evaluation evaluate(const DisparityMap& map, const cv::Mat1f& truth,
                            std::span<const double> deltas, const cv::Mat1b& mask = {});

}  // namespace xgm
