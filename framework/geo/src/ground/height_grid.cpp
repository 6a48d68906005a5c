// SPDX-License-Identifier: Apache-2.0
#include "ground/height_grid.hpp"

#include <algorithm>
#include <cmath>

namespace xgm::geo {
namespace {

/// The part of a line within [low, high] of one coordinate.
void clip(double from, double way, double low, double high, double& begin, double& end) {
  if (way == 0) {
    if (from < low || from > high) end = -1;
    return;
  }
  const double a = (low - from) / way, b = (high - from) / way;
  begin = std::max(begin, std::min(a, b));
  end = std::min(end, std::max(a, b));
}

/// Where a line leaves [low, low + length] of one coordinate.
double leaves(double from, double way, double low, double length) {
  if (way == 0) return INFINITY;
  return ((way > 0 ? low + length : low) - from) / way;
}

}  // namespace

HeightGrid::HeightGrid(const cv::Mat1f& heights, const GridPlace& place)
    : heights_(heights), place_(place) {
  block_.create((heights.rows + kBlock - 1) / kBlock, (heights.cols + kBlock - 1) / kBlock);
  for (int j = 0; j < block_.rows; ++j) {
    for (int i = 0; i < block_.cols; ++i) {
      // Patches of a block reach to the first cells of the next one.
      const cv::Rect cells =
          cv::Rect(i * kBlock, j * kBlock, kBlock + 1, kBlock + 1) & cv::Rect({}, heights.size());
      const cv::Mat1f part = heights(cells);
      block_(j, i) = *std::max_element(part.begin(), part.end());
    }
  }
  highest_ = double{*std::max_element(block_.begin(), block_.end())};
}

HeightGrid::Patch HeightGrid::patch(int i, int j) const {
  const double a{heights_(j, i)}, b{heights_(j, i + 1)};
  const double c{heights_(j + 1, i)}, d{heights_(j + 1, i + 1)};
  return {a, b - a, c - a, d - c - b + a};
}

HeightGrid::Point HeightGrid::at(double x, double y) const {
  const cv::Point2d cell = place_.cell({x, y});
  const int i = std::clamp(static_cast<int>(std::floor(cell.x)), 0, heights_.cols - 2);
  const int j = std::clamp(static_cast<int>(std::floor(cell.y)), 0, heights_.rows - 2);
  const double u = std::clamp(cell.x - i, 0.0, 1.0), v = std::clamp(cell.y - j, 0.0, 1.0);
  const Patch p = patch(i, j);
  return {p.h + u * p.hu + v * p.hv + u * v * p.huv, (p.hu + v * p.huv) / place_.step_x,
          (p.hv + u * p.huv) / place_.step_y};
}

std::optional<double> HeightGrid::hit_in(int i, int j, const cv::Vec3d& from, const cv::Vec3d& way,
                                         double begin, double end) const {
  const Patch p = patch(i, j);
  // Height of the line above the patch: c + b s + a s^2.
  const double u = from[0] - i, v = from[1] - j;
  const double c = from[2] - (p.h + u * p.hu + v * p.hv + u * v * p.huv);
  const double b = way[2] - (way[0] * p.hu + way[1] * p.hv + (u * way[1] + v * way[0]) * p.huv);
  const double a = -way[0] * way[1] * p.huv;
  const auto above = [&](double s) { return c + s * (b + s * a); };
  if (above(begin) <= 0) return begin;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return std::nullopt;
  // Stable for a near 0.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  double first = q != 0 ? c / q : INFINITY, second = a != 0 ? q / a : INFINITY;
  if (first > second) std::swap(first, second);
  for (const double s : {first, second}) {
    if (s >= begin && s <= end) return s;
  }
  return std::nullopt;
}

std::optional<double> HeightGrid::first_hit(const cv::Vec3d& from_map,
                                            const cv::Vec3d& to_map) const {
  const auto cells = [&](const cv::Vec3d& p) {
    const cv::Point2d cell = place_.cell({p[0], p[1]});
    return cv::Vec3d(cell.x, cell.y, p[2]);
  };
  const cv::Vec3d from = cells(from_map), way = cells(to_map) - from;
  const int columns = heights_.cols - 1, rows = heights_.rows - 1;  // of patches
  double s = 0, end = 1;
  clip(from[0], way[0], 0, columns, s, end);
  clip(from[1], way[1], 0, rows, s, end);
  if (s > end) return std::nullopt;
  int i = std::clamp(static_cast<int>(std::floor(from[0] + s * way[0])), 0, columns - 1);
  int j = std::clamp(static_cast<int>(std::floor(from[1] + s * way[1])), 0, rows - 1);
  while (s <= end) {
    // A whole block if the line passes above it, else one patch.
    const int bi = i / kBlock, bj = j / kBlock;
    const double out_x = leaves(from[0], way[0], bi * kBlock, kBlock);
    const double out_y = leaves(from[1], way[1], bj * kBlock, kBlock);
    const double out = std::min({out_x, out_y, end});
    const double lowest = from[2] + way[2] * (way[2] < 0 ? out : s);
    const bool skips = lowest > double{block_(bj, bi)};
    const int length = skips ? kBlock : 1;
    const int low_i = skips ? bi * kBlock : i, low_j = skips ? bj * kBlock : j;
    const double next_x = leaves(from[0], way[0], low_i, length);
    const double next_y = leaves(from[1], way[1], low_j, length);
    const double next = std::max(std::min(next_x, next_y), s);
    if (!skips) {
      if (const auto hit = hit_in(i, j, from, way, s, std::min(next, end))) return hit;
    }
    if (next >= end) return std::nullopt;
    const auto moved = [&](int axis, int low) {
      return std::clamp(static_cast<int>(std::floor(from[axis] + next * way[axis])), low,
                        low + length - 1);
    };
    const bool by_x = next_x <= next_y;
    j = by_x ? moved(1, low_j) : (way[1] > 0 ? low_j + length : low_j - 1);
    i = by_x ? (way[0] > 0 ? low_i + length : low_i - 1) : moved(0, low_i);
    if (i < 0 || j < 0 || i >= columns || j >= rows) return std::nullopt;
    s = next;
  }
  return std::nullopt;
}

}  // namespace xgm::geo
