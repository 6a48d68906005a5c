// SPDX-License-Identifier: Apache-2.0
// The pixels of a map that have no disparity, and how their colours differ from their neighbours'.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/image.hpp"

namespace xgm::plane_filling {

inline constexpr std::size_t kDirections = 8;
/// A step and the opposite one have the numbers k and kDirections - 1 - k; the first half leads to
/// pixels that come earlier, row by row.
inline const std::array<cv::Point, kDirections> kSteps{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// Pixels without a disparity or without image data, row by row.
struct Holes {
  std::vector<cv::Point> at;
  cv::Mat1i number;  ///< of a pixel among the holes; -1: is none
  /// Mean absolute difference of the planes to the neighbour at each of kSteps, grey levels; 0
  /// where either has no data.
  std::vector<std::array<float, kDirections>> distance;
  std::vector<std::uint8_t> is_filled;  ///< 1 where it shall be: not masked, with image data
};

XGM_API Holes find_holes(const DisparityMap& map, const Image& image);

}  // namespace xgm::plane_filling
