// SPDX-License-Identifier: Apache-2.0
// Sparsification: how well a confidence separates good from bad disparities. The more pixels of low
// confidence are removed, the fewer errors should remain.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "xgm/evaluation/metrics.hpp"

namespace xgm {

/// A figure of the pixels that are kept. An area is the mean of the figure over all numbers of kept
/// pixels, from one to all: the area under the curve over the share of kept pixels, 0 to 1.
struct SparsificationCurve {
  std::vector<double> value;    ///< one per Sparsification::kept
  std::vector<double> optimal;  ///< the same if pixels were sorted by their error
  double area = 0;
  double optimal_area = 0;
};

struct Sparsification {
  std::int64_t pixels = 0;   ///< pixels with a disparity and a known true disparity
  std::vector<double> kept;  ///< shares of kept pixels, ascending to 1
  std::vector<double> deltas;
  std::vector<SparsificationCurve> bad;  ///< share of bad pixels, 0 to 1, one per delta
  SparsificationCurve average_error;     ///< px after scaling
};

/// Keeps pixels in order of descending `confidence` (any unit; not finite = lowest) and computes
/// the errors at 5, 10, ... 100 % kept (whole pixels, rounded up). For pixels of equal confidence,
/// the result is the mean over all their orders, so that a coarse confidence has neither an
/// advantage nor a disadvantage. Counts the same pixels as evaluate(), by the same rules. Throws
/// Error if sizes differ or no pixel is left. Share of bad pixels, area and its optimum: Hu and
/// Mordohai, "A Quantitative Evaluation of Confidence Measures for Stereo Vision", PAMI 2012.
/// Average error: Bruhn and Weickert, "A Confidence Measure for Variational Optic Flow Methods",
/// 2006.
XGM_API Sparsification sparsification(const DisparityMap& map, const cv::Mat1f& truth,
                                      const cv::Mat1f& confidence, const EvaluationRules& rules,
                                      const cv::Mat1b& mask = {});

struct RegionSparsification {
  std::string region;
  Sparsification sparsification;
};

/// For all regions_of the truth in which some pixel has a disparity.
XGM_API std::vector<RegionSparsification> sparsification_by_region(const DisparityMap& map,
                                                                   const GroundTruth& truth,
                                                                   const cv::Mat1f& confidence,
                                                                   const EvaluationRules& rules);

}  // namespace xgm
