// SPDX-License-Identifier: Apache-2.0
// Segments of one colour, which no depth edge of the map parts.
#pragma once

#include <opencv2/core.hpp>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/image.hpp"

namespace xgm::plane_filling {

struct SegmentRules {
  double scale = 100;  ///< grey levels times pixels; larger makes larger segments
  int min_size = 30;   ///< smaller segments are joined with the neighbour most like them, px
  double jump = 1.5;   ///< neighbours whose disparities differ by more are not joined directly, px
};

struct Segments {
  cv::Mat1i label;  ///< 0 to count - 1; -1 where the image has no data
  int count = 0;
};

/// Graph-based segmentation (Felzenszwalb and Huttenlocher, IJCV 2004): pixels are joined with
/// their neighbours, the most alike first, while the difference is at most scale / size above the
/// largest inside of both segments.
XGM_API Segments find_segments(const DisparityMap& map, const Image& image,
                               const SegmentRules& rules);

}  // namespace xgm::plane_filling
