// SPDX-License-Identifier: Apache-2.0
// Composes a scene of surfaces and renders both views by looking along every pixel's line of sight.
#include "xgm/testing/synthetic.hpp"

#include <algorithm>
#include <cmath>

#include "testing/surface.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/testing/random.hpp"

namespace xgm::testing {

using namespace detail;

namespace {

constexpr double kSteepest = 0.25;  // disparity per pixel; keeps textures recognisable

std::array<double, 3> random_colour(Random& random, bool colour) {
  const double grey = random.real(95, 160);
  std::array<double, 3> level{grey, grey, grey};
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

Surface background(Random& random, const SceneOptions& options) {
  const double low = options.disparities.begin, high = options.disparities.end - 1;
  Surface surface;
  Plane& plane = surface.plane;
  plane.centre = {(options.size.width - 1) / 2.0, (options.size.height - 1) / 2.0};
  plane.d = low + 0.2 * (high - low);
  // The match view looks beyond the sides of the base image, and beyond its top if rows are
  // shifted.
  const double room = 0.2 * (high - low), margin = std::max(std::abs(low), std::abs(high));
  plane.slope_x = random_slope(random, room / 2, plane.centre.x + margin);
  plane.slope_y = random_slope(random, room / 2, plane.centre.y * 1.2);
  surface.texture = random.next();
  surface.level = random_colour(random, options.colour);
  return surface;
}

Surface object(Random& random, const SceneOptions& options) {
  const double low = options.disparities.begin, high = options.disparities.end - 1;
  Surface surface;
  Plane& plane = surface.plane;
  plane.centre = {random.real(0.05, 0.95) * options.size.width,
                  random.real(0.05, 0.95) * options.size.height};
  surface.half = {random.real(0.06, 0.18) * options.size.width,
                  random.real(0.08, 0.24) * options.size.height};
  surface.outline =
      random.integer(0, 1) == 0 ? Surface::Outline::rectangle : Surface::Outline::ellipse;
  plane.d = low + random.real(0.45, 0.88) * (high - low);
  const bool slanted = random.integer(0, 2) > 0;
  const double room = slanted ? 0.05 * (high - low) : 0;
  plane.slope_x = random_slope(random, room, surface.half.x);
  plane.slope_y = random_slope(random, room, surface.half.y);
  surface.texture = random.next();
  surface.level = random_colour(random, options.colour);
  return surface;
}

std::vector<Surface> compose(const SceneOptions& options) {
  Random random(options.seed);
  std::vector<Surface> surfaces{background(random, options)};
  for (int i = 0; i < options.objects; ++i) surfaces.push_back(object(random, options));
  return surfaces;
}

/// About normal, mean 0 and deviation 1: twelve uniform numbers (no libm, so the same everywhere).
double noise_at(std::uint64_t key, int channel, int y, int x) {
  Random random(
      mix(mix(mix(key + static_cast<std::uint64_t>(channel)) + static_cast<std::uint64_t>(y)) +
          static_cast<std::uint64_t>(x)));
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.real(0, 1);
  return sum;
}

Image empty_image(const SceneOptions& options) {
  Image image;
  for (int c = 0; c < (options.colour ? 3 : 1); ++c) image.planes.emplace_back(options.size);
  return image;
}

class Renderer {
 public:
  explicit Renderer(const SceneOptions& options) : options_(options), surfaces_(compose(options)) {
    scene_.pair = {empty_image(options), empty_image(options)};
    scene_.truth.create(options.size);
    scene_.reverse_truth.create(options.size);
    scene_.non_occluded.create(options.size);
    scene_.disparities = options.disparities;
  }

  SyntheticScene run() {
    parallel_for(0, options_.size.height, [this](int y) {
      for (int x = 0; x < options_.size.width; ++x) {
        base_pixel(y, x);
        match_pixel(y, x);
      }
    });
    return scene_;
  }

 private:
  void base_pixel(int y, int x) {
    const Sight sight = look_base(surfaces_, x, y);
    scene_.truth(y, x) = static_cast<float>(sight.disparity);
    scene_.non_occluded(y, x) = seen_in_match(sight, y) ? 255 : 0;
    paint(scene_.pair.base, sight, y, y, x, 1, 0, options_.seed + 1);
  }

  void match_pixel(int y, int x) {
    const VerticalShift& shift = options_.shift;
    const double aligned_y = (y - shift.a * x - shift.c) / (1 + shift.b);
    const Sight sight = look_match(surfaces_, x, aligned_y);
    scene_.reverse_truth(y, x) = static_cast<float>(-sight.disparity);
    paint(scene_.pair.match, sight, aligned_y, y, x, options_.gain, options_.bias,
          options_.seed + 2);
  }

  bool seen_in_match(const Sight& sight, int y) const {
    const double x_match = sight.x - sight.disparity;
    const double y_match = y + options_.shift.at(x_match, y);
    return x_match >= 0 && x_match <= options_.size.width - 1 && y_match >= 0 &&
           y_match <= options_.size.height - 1 &&
           look_match(surfaces_, x_match, y).surface == sight.surface;
  }

  void paint(Image& image, const Sight& sight, double texture_y, int y, int x, double gain,
             double bias, std::uint64_t noise_key) const {
    const Surface& surface = surfaces_[static_cast<std::size_t>(sight.surface)];
    for (std::size_t c = 0; c < image.planes.size(); ++c) {
      const int channel = static_cast<int>(c);
      double level = gain * surface.colour(channel, sight.x, texture_y) + bias;
      if (options_.noise > 0) level += options_.noise * noise_at(noise_key, channel, y, x);
      level = std::clamp(level, 0.0, 255.0);
      if (options_.whole_levels) level = std::floor(level + 0.5);
      image.planes[c](y, x) = static_cast<float>(level);
    }
  }

  const SceneOptions& options_;
  std::vector<Surface> surfaces_;
  SyntheticScene scene_;
};

}  // namespace

SyntheticScene make_scene(const SceneOptions& options) {
  if (options.size.empty() || options.disparities.empty())
    throw Error("a generated scene needs a size and disparities; give at least 1 x 1 and one");
  if (!(options.shift.b > -1))
    throw Error("a vertical shift with b <= -1 turns the image over; give b > -1");
  return Renderer(options).run();
}

SyntheticScene sample_scene() {
  SceneOptions options;
  options.size = {640, 480};
  options.disparities = {0, 64};
  options.seed = 3;
  options.objects = 9;
  options.colour = true;
  options.noise = 1;
  return make_scene(options);
}

}  // namespace xgm::testing
