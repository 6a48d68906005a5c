// SPDX-License-Identifier: Apache-2.0
// The edges between neighbouring pixels, in the order in which segments grow along them.
#pragma once

#include <cstdint>
#include <vector>

#include "xgm/data/disparity_map.hpp"
#include "xgm/data/image.hpp"

namespace xgm::plane_filling {

struct Edge {
  static constexpr int kSteps = 255;  ///< of a grey level; fewer would leave more to chance

  std::uint32_t begin;  ///< number of a pixel, row by row
  std::uint16_t steps;
  std::uint16_t is_down;  ///< 0: to the pixel on the right, 1: to the one below

  /// Mean absolute difference of the planes of both ends, smoothed, in whole steps; grey levels.
  float weight() const { return static_cast<float>(steps) / kSteps; }
};

/// Ascending by weight, then by pixel. Without those between pixels whose disparities differ by
/// more than `jump`, or that have no data.
std::vector<Edge> sorted_edges(const DisparityMap& map, const Image& image, double jump);

}  // namespace xgm::plane_filling
