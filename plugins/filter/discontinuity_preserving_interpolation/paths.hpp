// SPDX-License-Identifier: Apache-2.0
// The first disparities met along straight paths, for all holes at once.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

#include "xgm/data/disparity_map.hpp"

namespace xgm::discontinuity_preserving_interpolation {

/// The pixels to fill, numbered row by row: those of row y have the numbers from row_begin[y] to
/// row_begin[y + 1].
struct Holes {
  /// Pixels without a disparity that have image data.
  explicit Holes(const DisparityMap& map);

  std::vector<std::size_t> row_begin;
  std::vector<int> column;  ///< of each
};

/// Steps of the paths: 8 to the direct neighbours, or 16 with the knight's moves between them.
std::vector<cv::Point> path_steps(int directions);

/// Follows p, p + step, p + 2 step, ... from each hole p to the first pixel whose disparity is not
/// NaN. Returns one value per hole; NaN where the path leaves the image first. One sweep over the
/// map, however large the holes.
std::vector<float> first_along(const cv::Mat1f& disparity, const Holes& holes, cv::Point step);

}  // namespace xgm::discontinuity_preserving_interpolation
