// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "xgm/metrics.hpp"

namespace xgm {
namespace {

/// Whether some pixel with a truth is in the mask: evaluate() throws otherwise.
bool has_truth(const cv::Mat1f& truth, const cv::Mat1b& mask) {
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      if (mask(y, x) == 255 && std::isfinite(truth(y, x))) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<RegionEvaluation> evaluate_regions(const DisparityMap& map, const GroundTruth& truth,
                                               const EvaluationRules& rules) {
  std::vector<RegionEvaluation> regions{{"all", evaluate(map, truth.disparity, rules)}};
  const auto add = [&](const char* name, const cv::Mat1b& mask) {
    if (!has_truth(truth.disparity, mask)) return;
    regions.push_back({name, evaluate(map, truth.disparity, rules, mask)});
  };
  if (!truth.non_occluded.empty()) {
    add("non-occluded", truth.non_occluded);
    add("occluded", cv::Mat1b(truth.non_occluded != 255));
  }
  return regions;
}

}  // namespace xgm
