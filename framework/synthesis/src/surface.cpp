// SPDX-License-Identifier: Apache-2.0
#include "surface.hpp"

#include <algorithm>

namespace xgm::synthesis {
namespace {

/// Light from the upper left, before the scene.
constexpr double kLightX = -0.5, kLightY = -0.6, kLightZ = 0.6245;

/// Light is part of the surface, the same in both views: what a matte surface does.
double shading(const Shape& s, const Hit& hit) {
  if (s.form == Shape::Form::ellipsoid || s.form == Shape::Form::cylinder) {
    const double v = s.form == Shape::Form::ellipsoid ? hit.v : 0;
    const double nx = s.axis.x * hit.u - s.axis.y * v, ny = s.axis.y * hit.u + s.axis.x * v;
    return 0.45 + 0.65 * std::max(0.0, nx * kLightX + ny * kLightY + hit.w * kLightZ);
  }
  const double along_u = 2 * s.bend_u * hit.u / s.half.x, along_v = 2 * s.bend_v * hit.v / s.half.y;
  const double gx = s.slope_x + s.axis.x * along_u - s.axis.y * along_v;
  const double gy = s.slope_y + s.axis.y * along_u + s.axis.x * along_v;
  return std::clamp(0.9 + 1.5 * (gx * -kLightX + gy * kLightY), 0.5, 1.15);
}

}  // namespace

Levels Surface::colour(const Hit& hit, const Ray& ray, int channels) const {
  const double x = ray.x + ray.slope * hit.disparity;
  if (!lit) return texture.at({x, ray.y}, channels);
  // Half-way between the views, so that steep surfaces are stretched alike in both.
  const double dx = x - hit.disparity / 2 - (shape.centre.x - shape.d / 2);
  const double dy = ray.y - shape.centre.y;
  const cv::Point2d at{shape.axis.x * dx + shape.axis.y * dy,
                       shape.axis.x * dy - shape.axis.y * dx};
  Levels levels = texture.at(at, channels);
  const double light = shading(shape, hit);
  for (double& level : levels) level *= light;
  return levels;
}

std::vector<const Surface*> in_row(const Surfaces& surfaces, double y) {
  std::vector<const Surface*> found;
  for (const Surface& surface : surfaces)
    if (!surface.shape.misses({0, 0, y}, true)) found.push_back(&surface);
  return found;
}

Sight look(const std::vector<const Surface*>& surfaces, const Ray& ray) {
  Sight nearest;
  for (const Surface* surface : surfaces) {
    if (surface->shape.misses(ray)) continue;
    const auto hit = surface->shape.meet(ray);
    if (hit && (nearest.surface == nullptr || hit->disparity > nearest.hit.disparity))
      nearest = {surface, *hit};
  }
  return nearest;
}

}  // namespace xgm::synthesis
