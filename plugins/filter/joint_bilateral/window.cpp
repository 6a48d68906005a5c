// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/joint_bilateral/window.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/filter/joint_bilateral/votes.hpp"

namespace xgm::joint_bilateral {
namespace {

/// Mean absolute difference of the planes, so that sigma_range means the same for grey and colour.
float colour_distance(const std::vector<cv::Mat1f>& guide, cv::Point a, cv::Point b) {
  if (guide.size() == 1) return std::abs(guide[0](a) - guide[0](b));
  return (std::abs(guide[0](a) - guide[0](b)) + std::abs(guide[1](a) - guide[1](b)) +
          std::abs(guide[2](a) - guide[2](b))) /
         3.0F;
}

/// The votes for pixel (y, x), row by row; the window is cut off at the image border.
void collect(const Scene& scene, int y, int x, Votes& votes) {
  const cv::Size size = scene.disparity.size();
  const int radius = scene.weights.radius();
  const int left = std::max(0, x - radius), right = std::min(size.width, x + radius + 1);
  const int bottom = std::min(size.height, y + radius + 1);
  votes.clear();
  for (int row = std::max(0, y - radius); row < bottom; ++row) {
    const float* space = scene.weights.space_row(row - y);
    for (int column = left; column < right; ++column) {
      const float value = scene.disparity(row, column);
      if (std::isnan(value)) continue;
      const float distance = colour_distance(scene.guide, {column, row}, {x, y});
      const int weight = scene.weights(space[column - x], distance);
      if (weight > 0) votes.add(value + 0.0F, weight);  // -0 is 0: equal votes have equal bits
    }
  }
}

}  // namespace

void plain_filter(const Scene& scene, Mode mode, int y, cv::Range columns, float* filtered) {
  Votes votes;
  for (int x = columns.start; x < columns.end; ++x) {
    if (std::isnan(scene.disparity(y, x))) continue;
    collect(scene, y, x, votes);
    if (votes.empty()) continue;
    filtered[x] =
        mode == Mode::median ? votes.weighted_median() : static_cast<float>(votes.weighted_mean());
  }
}

}  // namespace xgm::joint_bilateral
