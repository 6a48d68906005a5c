// SPDX-License-Identifier: Apache-2.0
// Segments of a disparity map, as runs of pixels.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

namespace xgm::peak_removal {

/// The pixels [begin, end) of a row, which belong to one segment of `size` pixels.
struct Run {
  int begin = 0, end = 0;
  int size = 0;
};

/// The runs of a map, row by row: those of row y have the numbers from row_begin[y] to
/// row_begin[y + 1].
struct Segments {
  std::vector<Run> runs;
  std::vector<std::size_t> row_begin;
};

/// All pixels with a disparity. Two of them are in one segment if a chain of 4-connected neighbours
/// links them whose disparities differ by at most `max_difference` pixels from one to the next.
Segments find_segments(const cv::Mat1f& disparity, double max_difference);

}  // namespace xgm::peak_removal
