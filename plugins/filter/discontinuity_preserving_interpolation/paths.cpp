// SPDX-License-Identifier: Apache-2.0
// Paths as recurrences: what a pixel sees along a step is its own disparity, or else what the pixel
// one step ahead sees. Swept from the far end, each direction takes one pass over the map.
#include "plugins/filter/discontinuity_preserving_interpolation/paths.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace xgm::discontinuity_preserving_interpolation {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

/// One row of the recurrence; `ahead` is what the row step.y further sees (`here` itself if
/// step.y is 0).
void look(const float* disparity, int step_x, const std::vector<float>& ahead,
          std::vector<float>& here) {
  const int cols = static_cast<int>(here.size());
  for (int i = 0; i < cols; ++i) {
    const int x = step_x > 0 ? cols - 1 - i : i;
    const int next = x + step_x;
    float& seen = here[static_cast<std::size_t>(x)];
    seen = disparity[x];
    if (!std::isnan(seen)) continue;
    seen = next >= 0 && next < cols ? ahead[static_cast<std::size_t>(next)] : kNothing;
  }
}

}  // namespace

Holes::Holes(cv::Mat1b holes) : mask(std::move(holes)), row_begin{0} {
  for (int y = 0; y < mask.rows; ++y) {
    row_begin.push_back(row_begin.back() + static_cast<std::size_t>(cv::countNonZero(mask.row(y))));
  }
}

std::vector<cv::Point> path_steps(int directions) {
  std::vector<cv::Point> steps{{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                               {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
  if (directions == 16) {
    steps.insert(steps.end(),
                 {{2, 1}, {-2, 1}, {2, -1}, {-2, -1}, {1, 2}, {-1, 2}, {1, -2}, {-1, -2}});
  }
  return steps;
}

std::vector<float> first_along(const cv::Mat1f& disparity, const Holes& holes, cv::Point step) {
  const int rows = disparity.rows;
  const std::vector<float> outside(static_cast<std::size_t>(disparity.cols), kNothing);
  std::array<std::vector<float>, 3> ring;  // a knight's move looks two rows ahead
  ring.fill(outside);
  std::vector<float> first(holes.row_begin.back());
  for (int i = 0; i < rows; ++i) {
    const int y = step.y > 0 ? rows - 1 - i : i;
    const int next = y + step.y;
    std::vector<float>& here = ring[static_cast<std::size_t>(y % 3)];
    const bool inside = next >= 0 && next < rows;
    look(disparity[y], step.x, inside ? ring[static_cast<std::size_t>(next % 3)] : outside, here);
    std::size_t hole = holes.row_begin[static_cast<std::size_t>(y)];
    for (int x = 0; x < disparity.cols; ++x) {
      if (holes.mask(y, x) != 0) first[hole++] = here[static_cast<std::size_t>(x)];
    }
  }
  return first;
}

}  // namespace xgm::discontinuity_preserving_interpolation
