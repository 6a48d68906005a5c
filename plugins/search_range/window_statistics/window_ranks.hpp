// SPDX-License-Identifier: Apache-2.0
// Percentiles of the disparities around each pixel.
#pragma once

#include "plugins/search_range/window_statistics/proposal.hpp"
#include "xgm/data/disparity_map.hpp"

namespace xgm::search_range {

/// Which part of a window's disparities counts. Percentiles are nearest-rank: of n disparities in
/// ascending order, percentile p is number max(1, ceil(p n / 100)). So 0 is the smallest, 100 the
/// largest, and 50 the middle one (the lower of the two middle ones if n is even).
struct Percentiles {
  double low = 0;
  double high = 100;
};

/// For each pixel where `asked` is non-zero: from the low to the high percentile of the disparities
/// in the window x window pixels around it (pixels outside the image or without a disparity do not
/// count), relaxed. Pixels not asked for, or with an empty window, propose nothing. Exact: although
/// windows slide as histograms, their bins keep apart all that rounding to whole fine disparities
/// keeps apart.
Proposal window_ranks(const DisparityMap& coarse, const cv::Mat1b& asked, int window,
                      Percentiles percentiles, int relaxation);

/// 255 where the map has a disparity, else 0.
cv::Mat1b valid_pixels(const DisparityMap& map);

}  // namespace xgm::search_range
