// SPDX-License-Identifier: Apache-2.0
// Disparities as small whole numbers, for histograms.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "xgm/data/disparity_map.hpp"

namespace xgm::search_range {

/// A disparity's code is a whole number that keeps its order and tells both its fine_floor and its
/// fine_ceil: even codes are whole fine disparities, odd ones lie between two. Of these codes the
/// map holds indices into the ascending list of those that occur in it.
struct CodedMap {
  static constexpr int kNone = -1;

  explicit CodedMap(const DisparityMap& map);

  int fine_floor(int i) const { return codes[static_cast<std::size_t>(i)] >> 1; }
  int fine_ceil(int i) const { return (codes[static_cast<std::size_t>(i)] + 1) >> 1; }

  std::vector<int> codes;
  cv::Mat1i index;  ///< kNone where there is no disparity
};

}  // namespace xgm::search_range
