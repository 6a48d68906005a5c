// SPDX-License-Identifier: Apache-2.0
// Texture (value noise in four octaves) and visibility of the surfaces of generated scenes.
#include "testing/surface.hpp"

#include <cmath>

#include "xgm/testing/random.hpp"

namespace xgm::testing::detail {
namespace {

double lattice(std::uint64_t key, std::int64_t x, std::int64_t y) {
  return unit(mix(mix(key ^ static_cast<std::uint64_t>(x)) ^ static_cast<std::uint64_t>(y)));
}

double smooth(double t) { return t * t * (3 - 2 * t); }

/// Random values at whole coordinates, smoothly interpolated. 0 to 1.
double value_noise(std::uint64_t key, double u, double v) {
  const double u0 = std::floor(u), v0 = std::floor(v);
  const auto i = static_cast<std::int64_t>(u0), j = static_cast<std::int64_t>(v0);
  const double s = smooth(u - u0), t = smooth(v - v0);
  const double above = lattice(key, i, j) * (1 - s) + lattice(key, i + 1, j) * s;
  const double below = lattice(key, i, j + 1) * (1 - s) + lattice(key, i + 1, j + 1) * s;
  return above * (1 - t) + below * t;
}

/// From blobs down to detail of a few pixels: enough for a 3 x 3 window, little aliasing.
double octaves(std::uint64_t key, double x, double y) {
  constexpr std::array<double, 4> period{31.7, 13.3, 6.1, 3.2};
  constexpr std::array<double, 4> weight{0.3, 0.25, 0.25, 0.2};
  double sum = 0;
  for (std::size_t k = 0; k < period.size(); ++k)
    sum += weight[k] * value_noise(mix(key + k), x / period[k], y / period[k]);
  return sum;
}

void look(const Surface& surface, int index, double x, double y, Sight& nearest) {
  const double d = surface.plane.at(x, y);
  if (d > nearest.disparity && surface.covers(x, y)) nearest = {index, x, d};
}

}  // namespace

bool Surface::covers(double x, double y) const {
  const double u = (x - plane.centre.x) / half.x, v = (y - plane.centre.y) / half.y;
  switch (outline) {
    case Outline::everywhere:
      return true;
    case Outline::rectangle:
      return std::abs(u) <= 1 && std::abs(v) <= 1;
    case Outline::ellipse:
      return u * u + v * v <= 1;
  }
  return false;
}

double Surface::colour(int channel, double x, double y) const {
  const double brightness = octaves(texture, x, y);
  const double tint = octaves(mix(texture + 101 + static_cast<std::uint64_t>(channel)), x, y);
  const auto c = static_cast<std::size_t>(channel);
  return level[c] + contrast * (0.8 * brightness + 0.2 * tint - 0.5);
}

Sight look_base(const std::vector<Surface>& surfaces, double x, double y) {
  Sight nearest;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    look(surfaces[i], static_cast<int>(i), x, y, nearest);
  return nearest;
}

Sight look_match(const std::vector<Surface>& surfaces, double x_match, double y) {
  Sight nearest;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    look(surfaces[i], static_cast<int>(i), surfaces[i].plane.base_column(x_match, y), y, nearest);
  return nearest;
}

}  // namespace xgm::testing::detail
