// SPDX-License-Identifier: Apache-2.0
// How far a disparity map is from the truth: the figures of the paper's section 4.2, as defined by
// the Middlebury stereo evaluation, version 3, and those of KITTI.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/ground_truth.hpp"

namespace xgm {

struct EvaluationRules {
  std::vector<double> deltas;  ///< thresholds, px after scaling
  /// Errors are multiplied by it before they are judged and averaged: 4 judges a map of quarter
  /// resolution in pixels of full resolution, as the benchmark does.
  double scale = 1;
  /// Disparities outside are moved to its ends first, as the benchmark does. Empty: as they are.
  /// Whole px of the map; the end is exclusive, so [0, 70) moves 73.2 to 69.
  Interval clip{};
};

/// Shares of the judged pixels at one threshold, 0 to 1.
struct ThresholdScore {
  double delta = 1;  ///< px after scaling
  double bad = 0;    ///< has a disparity, but more than delta off
  double total = 0;  ///< bad + invalid
};

/// Errors are those of pixels that have both a disparity and a truth, px after scaling; NaN if
/// there is no such pixel.
struct Evaluation {
  std::int64_t judged = 0;   ///< pixels that have a true disparity and are not masked out
  double invalid = 0;        ///< share of them without a disparity, 0 to 1
  double average_error = 0;  ///< mean |d - truth|
  double rms = 0;            ///< root of the mean of (d - truth)^2
  double a50 = 0;            ///< half of the errors are at most this; likewise 90, 95 and 99 %
  double a90 = 0;
  double a95 = 0;
  double a99 = 0;
  double d1 = 0;  ///< share with an error above 3 px and above 5 % of the truth, or no disparity
  std::vector<ThresholdScore> at;  ///< one per threshold asked for, in that order

  double coverage() const { return 1 - invalid; }
};

/// Compares `map` with `truth` (px, not finite = none), only where `mask` is 255 (the benchmarks'
/// value for "not occluded") if there is one. Throws Error if the sizes differ or nothing is left
/// to judge.
XGM_API Evaluation evaluate(const DisparityMap& map, const cv::Mat1f& truth,
                            const EvaluationRules& rules, const cv::Mat1b& mask = {});

/// The figures of one part of the scene.
struct RegionEvaluation {
  std::string region;  ///< "all", "non-occluded", "occluded", "near discontinuities", ...
  Evaluation evaluation;
};

/// Judges "all" of the truth and, as far as the truth tells them apart and they have pixels,
/// "non-occluded", "occluded" and "near discontinuities" pixels, KITTI's "background" and
/// "foreground". In this order. Throws Error like evaluate.
XGM_API std::vector<RegionEvaluation> evaluate_regions(const DisparityMap& map,
                                                       const GroundTruth& truth,
                                                       const EvaluationRules& rules);

}  // namespace xgm
