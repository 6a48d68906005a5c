// SPDX-License-Identifier: Apache-2.0
#include "metrics/discontinuities.hpp"
#include "metrics/errors.hpp"

namespace xgm {
namespace {

constexpr int kOccluded = 128;  // in Middlebury V3's masks, where 0 means that nothing is known

bool has_truth(const cv::Mat1f& truth, const cv::Mat1b& mask) {
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      if (is_judged(truth, mask, y, x)) return true;
    }
  }
  return false;
}

cv::Mat1b occluded(const cv::Mat1b& non_occluded) {
  const cv::Mat1b said_so(non_occluded == kOccluded);
  return cv::countNonZero(said_so) > 0 ? said_so : cv::Mat1b(non_occluded != kJudged);
}

}  // namespace

std::vector<Region> regions_of(const GroundTruth& truth) {
  std::vector<Region> regions{{"all", {}}};
  const auto add = [&](const char* name, const cv::Mat1b& mask) {
    if (has_truth(truth.disparity, mask)) regions.push_back({name, mask});
  };
  if (!truth.non_occluded.empty()) {
    require_size(truth.non_occluded.size(), truth.disparity.size(), "mask of non-occluded pixels");
    const cv::Mat1b visible(truth.non_occluded == kJudged);
    add("non-occluded", visible);
    add("occluded", occluded(truth.non_occluded));
    add("near discontinuities", cv::Mat1b(visible & near_discontinuities(truth.disparity)));
  }
  if (!truth.objects.empty()) {
    require_size(truth.objects.size(), truth.disparity.size(), "object map");
    add("background", cv::Mat1b(truth.objects == 0));
    add("foreground", cv::Mat1b(truth.objects != 0));
  }
  return regions;
}

std::vector<RegionEvaluation> evaluate_regions(const DisparityMap& map, const GroundTruth& truth,
                                               const EvaluationRules& rules) {
  require_size(truth.disparity.size(), map.size(), "truth");
  std::vector<RegionEvaluation> evaluations;
  for (const auto& [name, mask] : regions_of(truth)) {
    evaluations.push_back({name, evaluate(map, truth.disparity, rules, mask)});
  }
  return evaluations;
}

}  // namespace xgm
