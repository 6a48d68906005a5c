// SPDX-License-Identifier: Apache-2.0
#include "plugins/search_range/window_statistics/window_ranks.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/search_range/window_statistics/ranked_windows.hpp"

namespace xgm::search_range {

int RankedWindows::rank(double percentile, int total) {
  return std::max(1, static_cast<int>(std::ceil(percentile * total / 100)));
}

Proposal window_ranks(const DisparityMap& coarse, const cv::Mat1b& asked, int window,
                      Percentiles percentiles, int relaxation) {
  const CodedMap map(coarse);
  Proposal proposal(coarse.size());
  const RankedWindows windows{map, asked, window / 2, percentiles, relaxation, proposal};
  if (map.codes.empty()) return proposal;
  if (columns_fit(windows)) {
    rank_by_columns(windows);
  } else {
    rank_by_sliding(windows);
  }
  return proposal;
}

cv::Mat1b valid_pixels(const DisparityMap& map) {
  cv::Mat1b valid(map.size());
  for (int y = 0; y < valid.rows; ++y) {
    for (int x = 0; x < valid.cols; ++x) valid(y, x) = map.has_disparity(y, x) ? 255 : 0;
  }
  return valid;
}

}  // namespace xgm::search_range
