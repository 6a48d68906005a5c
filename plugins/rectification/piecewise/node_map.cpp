// SPDX-License-Identifier: Apache-2.0
#include "plugins/rectification/piecewise/node_map.hpp"

#include <algorithm>
#include <cmath>

namespace xgm::geo {
namespace {

constexpr double kPrecision = 1e-10;  // of a step
constexpr int kMaxRounds = 30;

}  // namespace

NodeMap::NodeMap(cv::Mat2d nodes, cv::Point2d first, cv::Size2d step)
    : nodes_(std::move(nodes)), first_(first), step_(step) {}

NodeMap::Local NodeMap::at(cv::Point2d grid) const {
  const auto cell = [](double place, int count) {
    return static_cast<int>(std::clamp(std::floor(place), 0.0, count - 2.0));
  };
  const int i = cell(grid.x, nodes_.cols), j = cell(grid.y, nodes_.rows);
  const double u = grid.x - i, v = grid.y - j;
  const cv::Vec2d &a = nodes_(j, i), &b = nodes_(j, i + 1), &c = nodes_(j + 1, i),
                  &d = nodes_(j + 1, i + 1);
  const cv::Vec2d upper = b - a, lower = d - c, left = c - a, right = d - b;
  const cv::Vec2d by_x = upper + v * (lower - upper), by_y = left + u * (right - left);
  return {a + u * upper + v * left + u * v * (lower - upper), {by_x[0], by_y[0], by_x[1], by_y[1]}};
}

cv::Point2d NodeMap::operator()(cv::Point2d place) const {
  const cv::Point2d from = place - first_;
  return cv::Point2d(at({from.x / step_.width, from.y / step_.height}).value);
}

cv::Point2d NodeMap::inverse(cv::Point2d value) const {
  // Newton's iteration, from the middle: the map is all but affine, so that it converges at once,
  // and in the last cell it is exact but for the product of u and v.
  cv::Point2d grid((nodes_.cols - 1) / 2.0, (nodes_.rows - 1) / 2.0);
  for (int round = 0; round < kMaxRounds; ++round) {
    const Local here = at(grid);
    const cv::Matx22d& m = here.derivatives;
    const double x = value.x - here.value[0], y = value.y - here.value[1];
    const double determinant = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
    const cv::Point2d change((m(1, 1) * x - m(0, 1) * y) / determinant,
                             (m(0, 0) * y - m(1, 0) * x) / determinant);
    grid += change;
    if (!(std::abs(change.x) + std::abs(change.y) > kPrecision)) break;
  }
  return first_ + cv::Point2d(grid.x * step_.width, grid.y * step_.height);
}

}  // namespace xgm::geo
