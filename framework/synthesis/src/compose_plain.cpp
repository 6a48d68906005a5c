// SPDX-License-Identifier: Apache-2.0
// Flat things before a slanted background: enough for most tests, and easy to foresee.
#include <algorithm>
#include <cmath>

#include "compose.hpp"
#include "xgm/base/random.hpp"

namespace xgm::synthesis {
namespace {

constexpr double kSteepest = 0.25;  // disparity per pixel; keeps textures recognisable

Levels random_colour(Random& random, bool colour) {
  const double grey = random.real(95, 160);
  Levels level{grey, grey, grey};
  for (double& channel : level) {
    const double tint = random.real(-45, 45);
    if (colour) channel += tint;
  }
  return level;
}

/// A slope that moves the disparity by at most `room` within `reach` pixels to either side.
double random_slope(Random& random, double room, double reach) {
  return random.real(-1, 1) * std::min(kSteepest, room / std::max(reach, 1.0));
}

Surface background(Random& random, const Options& options) {
  const double low = options.disparities.begin, high = options.disparities.end - 1;
  Surface surface;
  Shape& plane = surface.shape;
  plane.centre = {(options.size.width - 1) / 2.0, (options.size.height - 1) / 2.0};
  plane.d = low + 0.2 * (high - low);
  // The match view looks beyond the sides of the base image, and beyond its top if rows are
  // shifted.
  const double room = 0.2 * (high - low), margin = std::max(std::abs(low), std::abs(high));
  plane.slope_x = random_slope(random, room / 2, plane.centre.x + margin);
  plane.slope_y = random_slope(random, room / 2, plane.centre.y * 1.2);
  surface.texture.key = random.next();
  surface.texture.level = random_colour(random, options.colour);
  return surface;
}

Surface object(Random& random, const Options& options) {
  const double low = options.disparities.begin, high = options.disparities.end - 1;
  Surface surface;
  Shape& plane = surface.shape;
  plane.centre = {random.real(0.05, 0.95) * options.size.width,
                  random.real(0.05, 0.95) * options.size.height};
  plane.half = {random.real(0.06, 0.18) * options.size.width,
                random.real(0.08, 0.24) * options.size.height};
  plane.outline.kind =
      random.integer(0, 1) == 0 ? Outline::Kind::rectangle : Outline::Kind::ellipse;
  plane.d = low + random.real(0.45, 0.88) * (high - low);
  const bool slanted = random.integer(0, 2) > 0;
  const double room = slanted ? 0.05 * (high - low) : 0;
  plane.slope_x = random_slope(random, room, plane.half.x);
  plane.slope_y = random_slope(random, room, plane.half.y);
  surface.texture.key = random.next();
  surface.texture.level = random_colour(random, options.colour);
  return surface;
}

}  // namespace

Surfaces compose_plain(const Options& options) {
  Random random(options.seed);
  Surfaces surfaces{background(random, options)};
  for (int i = 0; i < options.objects; ++i) surfaces.push_back(object(random, options));
  return surfaces;
}

}  // namespace xgm::synthesis
