// SPDX-License-Identifier: Apache-2.0
// Whether a confidence tells good disparities from bad ones: the less sure pixels are dropped, the
// fewer errors should be among those kept.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "xgm/evaluation/metrics.hpp"

namespace xgm {

/// A figure of the pixels kept. The areas are the mean of the figure over all numbers of pixels
/// that can be kept, from one to all: the area under the curve over a share kept of 0 to 1.
struct SparsificationCurve {
  std::vector<double> value;    ///< one per Sparsification::kept
  std::vector<double> optimal;  ///< the same if pixels were sorted by their error
  double area = 0;
  double optimal_area = 0;
};

struct Sparsification {
  std::int64_t pixels = 0;   ///< that have both a disparity and a truth
  std::vector<double> kept;  ///< shares of them, rising to 1
  std::vector<double> deltas;
  std::vector<SparsificationCurve> bad;  ///< share of bad pixels, 0 to 1, one per delta
  SparsificationCurve average_error;     ///< px after scaling
};

/// Keeps pixels in the order of falling `confidence` (any unit; not finite = least sure) and tells
/// what is left of the errors at 5, 10, ... 100 % kept (whole pixels, rounded up). Pixels of equal
/// confidence are kept as if their order were drawn by lot, on average: no order of the pixels
/// favours or harms a coarse confidence. Only pixels are counted that evaluate() compares, by the
/// same rules. Throws Error if sizes differ or no pixel is left.
/// Share of bad pixels, area and its optimum: Hu and Mordohai, "A Quantitative Evaluation of
/// Confidence Measures for Stereo Vision", PAMI 2012. Average error: Bruhn and Weickert, "A
/// Confidence Measure for Variational Optic Flow Methods", 2006.
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
