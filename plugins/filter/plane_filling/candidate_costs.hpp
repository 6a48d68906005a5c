// SPDX-License-Identifier: Apache-2.0
// What the images and the disparities that are known say about a candidate.
#pragma once

#include <cstdint>
#include <vector>

#include "plugins/filter/plane_filling/candidates.hpp"

namespace xgm::plane_filling {

struct CostRules {
  float occlusion = 0.35F;   ///< matching cost of what the match image does not show
  float hides = 0.6F;        ///< cost of hiding what was matched
  float path = 0.02F;        ///< cost of a grey level of colour difference on the path
  bool near_is_high = true;  ///< whether the larger disparity is the nearer one
};

class XGM_API CandidateCosts {
 public:
  CandidateCosts(const DisparityMap& map, const ImagePair& pair, const CostRules& rules);

  /// Of a candidate of this pixel: how little the images match there, 0 to 1, and what the rules
  /// add.
  float of(cv::Point pixel, const Candidate& candidate) const;

 private:
  float matching_cost(cv::Point pixel, float disparity, int there) const;
  bool is_nearer(float a, float b) const;

  CostRules rules_;
  const ImagePair& pair_;
  cv::Mat1f base_, match_;                                 ///< grey levels
  std::vector<std::uint64_t> base_census_, match_census_;  ///< pixel by pixel
  cv::Mat1f claimed_;  ///< of a match pixel: the nearest disparity that points at it; NaN: none
};

}  // namespace xgm::plane_filling
