// SPDX-License-Identifier: Apache-2.0
// What is known of the candidates everywhere before single pixels are looked at.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "xgm/stage/cost.hpp"
#include "xgm/stage/fuser.hpp"
#include "xgm/stage/needs.hpp"
#include "xgm/stage/slot.hpp"

namespace xgm::fuser {

/// Stands in a map of costs where there is none.
constexpr int kNoCost = 255;

/// Candidates that are farther apart are worth a decision.
constexpr float kDispute = 0.25F;

struct CandidateMaps {
  CandidateMaps(const Candidates& candidates, const ImagePair& pair, const SlotList<Cost>& costs,
                const Context& context);

  int matchers() const { return static_cast<int>(candidates.maps.size()); }
  const cv::Mat1b& cost(int matcher, int k) const {
    return costs[static_cast<std::size_t>(matcher * costs_per_matcher + k)];
  }
  /// Whether there are candidates more than kDispute apart.
  bool disputed(int y, int x) const;

  const Candidates& candidates;
  const ImagePair& pair;
  int costs_per_matcher;
  /// Each cost of each matcher's disparities, 0 to 254 = the cost's bound; 255: none.
  std::vector<cv::Mat1b> costs;
  /// How far each matcher's nearest pixel without a match is, px; 0: it has none itself.
  std::vector<cv::Mat1b> hole_distance;
  /// The disparity of the first candidate where none disputes it, else NaN.
  cv::Mat1f agreed;
  cv::Mat1f grey;  ///< of the base image
};

/// What CandidateMaps and a volume of costs while they are made take.
Needs needs_of_maps(const Workload& load, int matchers, int costs);

}  // namespace xgm::fuser
