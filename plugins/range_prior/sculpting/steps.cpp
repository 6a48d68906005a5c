// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "plugins/range_prior/sculpting/sculpting.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::geo {
namespace {

/// A surface moved up or down, as far as a camera reaches.
class Moved final : public HeightField {
 public:
  Moved(const HeightField& surface, double offset, const RpcCamera& camera)
      : surface_(surface), offset_(offset), reach_(camera.reach()) {}
  std::optional<double> height(double longitude, double latitude) const override {
    const auto height = surface_.height(longitude, latitude);
    return height ? std::optional(moved(*height)) : std::nullopt;
  }
  HeightInterval bounds() const override {
    const HeightInterval bounds = surface_.bounds();
    return {moved(bounds.min), moved(bounds.max)};
  }
  double posting() const override { return surface_.posting(); }

 private:
  double moved(double height) const {
    // Lines of sight begin and end a metre beyond the surface.
    return std::clamp(height + offset_, reach_.min + 1, reach_.max - 1);
  }

  const HeightField& surface_;
  double offset_;
  HeightInterval reach_;
};

cv::Vec2i nearest(const SparseBounds& sparse, int row, int column) {
  const int reach = std::max(sparse.rows, sparse.cols);
  int best = 2 * reach * reach + 1;
  cv::Vec2i found(0, 0);
  for (int r = 0; r < sparse.rows; ++r) {
    for (int c = 0; c < sparse.cols; ++c) {
      const int distance = (r - row) * (r - row) + (c - column) * (c - column);
      if (distance >= best || is_empty(sparse(r, c))) continue;
      best = distance;
      found = sparse(r, c);
    }
  }
  return found;
}

}  // namespace

void describe_sculpting(SculptingParameters& p, ParameterSet& set, const std::string& surface) {
  set.add("upper", p.upper,
          "Share of what the camera's heights reach above " + surface +
              ", by which the upper surface is moved up.")
      .range(0, 1);
  set.add("lower", p.lower, "The same below " + surface + ", for the lower surface.").range(0, 1);
  set.add("margin", p.margin,
          "What both surfaces are moved by at least, for buildings, trees and errors of " +
              surface + ". 0: the shares alone.")
      .unit("m")
      .range(0, 1000);
  set.add("step", p.step, "Distance of the pixels that are projected; others are like the nearest.")
      .unit("px")
      .range(1, 512);
}

HeightInterval sculpting_offsets(const SculptingParameters& p, const HeightInterval& camera,
                                 const HeightInterval& surface) {
  return {std::min(p.lower * (camera.min - surface.min), -p.margin),
          std::max(p.upper * (camera.max - surface.max), p.margin)};
}

SparseBounds sparse_bounds(const RectifiedPair& pair, const HeightField& lower,
                           const HeightField& upper, const HeightInterval& moves, int step) {
  const RpcCamera& camera = pair.base.camera;
  const Moved floor(lower, moves.min, camera), ceiling(upper, moves.max, camera);
  const cv::Size size = pair.geometry->size();
  const auto points = [&](int length) { return (length - 1) / step + 1; };
  SparseBounds bounds(points(size.height), points(size.width), cv::Vec2i(0, 0));
  parallel_for(0, bounds.rows, [&](int row) {
    for (int column = 0; column < bounds.cols; ++column) {
      const cv::Point2d pixel = pair.geometry->to_base(cv::Point2d(column * step, row * step));
      const auto high = camera.localize(pixel, ceiling);
      const auto low = camera.localize(pixel, floor);
      if (!high || !low) continue;
      const double a = pair.see(*low)[2], b = pair.see(*high)[2];
      bounds(row, column) = {static_cast<int>(std::floor(std::min(a, b))),
                             static_cast<int>(std::ceil(std::max(a, b))) + 1};
    }
  });
  return bounds;
}

SparseBounds filled_by_nearest(const SparseBounds& sparse) {
  SparseBounds filled = sparse.clone();
  for (int row = 0; row < sparse.rows; ++row) {
    for (int column = 0; column < sparse.cols; ++column) {
      if (is_empty(sparse(row, column))) filled(row, column) = nearest(sparse, row, column);
    }
  }
  return filled;
}

DisparityRange spread(const SparseBounds& sparse, cv::Size size, int step) {
  return DisparityRange::of_pixels(size, [&](int y, int x) {
    const int row = std::min((y + step / 2) / step, sparse.rows - 1);
    const int column = std::min((x + step / 2) / step, sparse.cols - 1);
    const cv::Vec2i bounds = sparse(row, column);
    return Interval{bounds[0], bounds[1]};
  });
}

}  // namespace xgm::geo
