// SPDX-License-Identifier: Apache-2.0
// How much a range prior leaves to be searched, and whether the truth is among it.
#pragma once

#include "xgm/geo/image/rectified_pair.hpp"
#include "xgm/plugin.hpp"

namespace xgm::testing {

/// Sum of the disparities of all pixels.
inline double search_volume(const DisparityRange& range) {
  double cells = 0;
  for (int y = 0; y < range.size().height; ++y) {
    for (int x = 0; x < range.size().width; ++x) cells += range.at(y, x).size();
  }
  return cells;
}

inline double searched_per_pixel(const DisparityRange& range) {
  return search_volume(range) / static_cast<double>(range.size().area());
}

/// Share of the base image's pixels, every third, whose true disparity is searched. `heights` are
/// those of what the pixels show.
inline double truth_searched(const geo::RectifiedPair& pair, const DisparityRange& range,
                             const cv::Mat1f& heights) {
  int inside = 0, all = 0;
  for (int y = 0; y < heights.rows; y += 3) {
    for (int x = 0; x < heights.cols; x += 3) {
      const auto point = pair.base.camera.localize(cv::Point2d(x, y), double{heights(y, x)});
      if (!point) continue;
      const cv::Vec3d seen = pair.see(*point);
      const cv::Point pixel(cvRound(seen[0]), cvRound(seen[1]));
      if (!cv::Rect({}, range.size()).contains(pixel)) continue;
      const Interval searched = range.at(pixel.y, pixel.x);
      ++all;
      inside += seen[2] >= searched.begin && seen[2] <= searched.end - 1;
    }
  }
  return static_cast<double>(inside) / all;
}

}  // namespace xgm::testing
