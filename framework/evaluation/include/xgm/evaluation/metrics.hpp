// SPDX-License-Identifier: Apache-2.0
// Errors of a disparity map with respect to ground truth: the figures of section 4.2 of the paper,
// as defined by the Middlebury stereo evaluation, version 3, and those of KITTI. docs/evaluate.md
// explains them.
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

/// The default thresholds of programs, px.
inline std::vector<double> usual_thresholds() { return {0.5, 1, 2, 4}; }

struct EvaluationRules {
  std::vector<double> deltas;  ///< thresholds, px after scaling
  /// Factor of all errors before they are compared and averaged: with 4, errors of a map of quarter
  /// resolution are in pixels of the full resolution, as in the benchmark.
  double scale = 1;
  /// Disparities outside this interval are first moved to its nearer end, as in the benchmark.
  /// Empty: disparities are unchanged. Whole px of the map; the end is exclusive, so [0, 70)
  /// moves 73.2 to 69.
  Interval clip{};
};

/// The clip of the Middlebury evaluation for a search range: it moves disparities into 0 to ndisp,
/// both included, although the largest disparity to search is ndisp - 1.
inline Interval benchmark_clip(Interval searched) { return {searched.begin, searched.end + 1}; }

/// Shares of the evaluated pixels at one threshold, 0 to 1.
struct ThresholdScore {
  double delta = 1;  ///< px after scaling
  double bad = 0;    ///< pixels that have a disparity with an error above delta
  double total = 0;  ///< invalid + bad, to the last bit
};

/// The figures of one region. Errors are those of pixels that have a disparity and a known true
/// disparity, px after scaling; NaN if there is no such pixel.
struct Evaluation {
  std::int64_t judged = 0;   ///< pixels that have a true disparity and are not masked out
  double invalid = 0;        ///< share of them without a disparity, 0 to 1
  double average_error = 0;  ///< mean |d - truth|
  double rms = 0;            ///< root mean square of d - truth
  double a50 = 0;            ///< half of the errors are at most this; likewise 90, 95 and 99 %
  double a90 = 0;
  double a95 = 0;
  double a99 = 0;
  /// KITTI 2015's D1: share with an error above 3 px (after scaling) and above 5 % of the truth, or
  /// without a disparity. KITTI fills holes before it counts; here holes count as errors.
  double d1 = 0;
  std::vector<ThresholdScore> at;  ///< one per threshold asked for, in that order

  double coverage() const { return 1 - invalid; }
};

/// Compares `map` with `truth` (px, not finite = unknown). If `mask` is given, only where it is 255
/// (the value for "not occluded" of the benchmarks). Throws Error if sizes differ or no pixel can
/// be evaluated.
XGM_API Evaluation evaluate(const DisparityMap& map, const cv::Mat1f& truth,
                            const EvaluationRules& rules, const cv::Mat1b& mask = {});

/// A part of the scene that is evaluated separately.
struct Region {
  std::string name;
  cv::Mat1b mask;  ///< 255 where a pixel belongs to it; empty: every pixel does
};

/// The regions that the ground truth defines and that have pixels with a known true disparity, in
/// this order:
/// - "all"
/// - "non-occluded": 255 in the mask of non-occluded pixels
/// - "occluded": 128 in that mask if it has that value (Middlebury V3: 0 = not known), otherwise
///   every other value than 255
/// - "near discontinuities": non-occluded, and within 4 px (a window of 9 x 9) of a pixel whose
///   true disparity differs from a horizontal or vertical neighbour's by more than 2 px of the map
///   (Scharstein and Szeliski, IJCV 2002, section 5.1: eval_disp_gap, eval_discont_width)
/// - "background", "foreground": 0 and not 0 in the object map (Menze and Geiger, CVPR 2015)
/// "all" is included even if it has no pixel. Throws Error if the maps differ in size.
XGM_API std::vector<Region> regions_of(const GroundTruth& truth);

/// A region and its figures.
struct RegionEvaluation {
  std::string region;
  Evaluation evaluation;
};

/// Evaluates all regions_of the truth. Throws Error like evaluate.
XGM_API std::vector<RegionEvaluation> evaluate_regions(const DisparityMap& map,
                                                       const GroundTruth& truth,
                                                       const EvaluationRules& rules);

}  // namespace xgm
