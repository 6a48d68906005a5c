// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/plane_filling/holes.hpp"

#include <cmath>
#include <numeric>

#include "xgm/base/parallel.hpp"

namespace xgm::plane_filling {
namespace {

bool is_hole(const DisparityMap& map, const Image& image, int y, int x) {
  return !map.has_disparity(y, x) || !image.is_valid(y, x);
}

/// For each row the number of holes above it; then that of all holes.
std::vector<std::size_t> holes_above(const DisparityMap& map, const Image& image) {
  std::vector<std::size_t> above(static_cast<std::size_t>(map.size().height) + 1, 0);
  parallel_for(0, map.size().height, [&](int y) {
    std::size_t count = 0;
    for (int x = 0; x < map.size().width; ++x) count += is_hole(map, image, y, x) ? 1U : 0U;
    above[static_cast<std::size_t>(y) + 1] = count;
  });
  std::partial_sum(above.begin(), above.end(), above.begin());
  return above;
}

std::array<float, kDirections> distances(const Image& image, cv::Point here) {
  std::array<float, kDirections> result{};
  if (!image.is_valid(here.y, here.x)) return result;
  const cv::Rect inside({}, image.size());
  for (std::size_t k = 0; k < kDirections; ++k) {
    const cv::Point there = here + kSteps[k];
    if (!inside.contains(there) || !image.is_valid(there.y, there.x)) continue;
    float sum = 0;
    for (const cv::Mat1f& plane : image.planes) sum += std::abs(plane(here) - plane(there));
    result[k] = sum / static_cast<float>(image.planes.size());
  }
  return result;
}

}  // namespace

Holes find_holes(const DisparityMap& map, const Image& image) {
  const std::vector<std::size_t> above = holes_above(map, image);
  Holes holes{std::vector<cv::Point>(above.back()), cv::Mat1i(map.size(), -1),
              std::vector<std::array<float, kDirections>>(above.back()),
              std::vector<std::uint8_t>(above.back())};
  parallel_for(0, map.size().height, [&](int y) {
    std::size_t hole = above[static_cast<std::size_t>(y)];
    for (int x = 0; x < map.size().width; ++x) {
      if (!is_hole(map, image, y, x)) continue;
      holes.number(y, x) = static_cast<int>(hole);
      holes.at[hole] = {x, y};
      holes.distance[hole] = distances(image, {x, y});
      holes.is_filled[hole] = map.at(y, x) != Status::masked && image.is_valid(y, x) ? 1 : 0;
      ++hole;
    }
  });
  return holes;
}

}  // namespace xgm::plane_filling
