// SPDX-License-Identifier: Apache-2.0
// Key points by what they look like, and which of two views look like each other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

namespace xgm::ransac_deskew {

/// SIFT's 128 whole numbers from 0 to 255. 16 bits hold their differences, too, and vectors many of
/// them.
using Descriptor = std::array<std::int16_t, 128>;

struct KeyPoints {
  std::vector<cv::Point2f> at;
  std::vector<Descriptor> descriptors;  ///< one for each point

  /// `descriptor` has 128 whole numbers.
  void add(cv::Point2f point, const float* descriptor);
  void add(const KeyPoints& others);
};

/// The pairs (i, j) of key points that are each other's best match and clearly so: the best
/// distance (L2) is below `ratio` times the second best. In ascending order of i.
std::vector<std::pair<std::size_t, std::size_t>> mutual_matches(const KeyPoints& base,
                                                                const KeyPoints& match,
                                                                double ratio);

}  // namespace xgm::ransac_deskew
