// SPDX-License-Identifier: Apache-2.0
#include "camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "xgm/base/parallel.hpp"
#include "xgm/base/random.hpp"
#include "xgm/synthesis/arithmetic.hpp"

namespace xgm::synthesis {
namespace {

using random_bits::mix;

/// About normal, mean 0 and deviation 1: twelve uniform numbers (no libm, so the same everywhere).
double noise_at(std::uint64_t key, std::uint64_t channel, int y, int x) {
  Random random(
      mix(mix(mix(key + channel) + static_cast<std::uint64_t>(y)) + static_cast<std::uint64_t>(x)));
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.real(0, 1);
  return sum;
}

/// A reflection: the brightest in its middle.
struct Spot {
  cv::Point2d centre;
  cv::Point2d half;

  double at(double x, double y) const {
    const double u = (x - centre.x) / half.x, v = (y - centre.y) / half.y;
    const double r2 = u * u + v * v;
    return r2 >= 1 ? 0 : (1 - r2) * (1 - r2);
  }
};

/// Reflections wander with the eye: where they are in the match view has nothing to do with
/// disparities.
std::array<Spot, 6> spots(const Options& options, bool match) {
  Random random(mix(options.seed + 71));
  std::array<Spot, 6> result;
  const double width = options.size.width, height = options.size.height;
  for (Spot& spot : result) {
    spot.centre = {random.real(0.05, 0.95) * width, random.real(0.05, 0.95) * height};
    spot.half = {std::max(1.0, random.real(0.04, 0.12) * width),
                 std::max(1.0, random.real(0.06, 0.2) * height)};
    const double wander = random.real(-0.12, 0.12) * width;
    if (match) spot.centre.x += wander;
  }
  return result;
}

class Camera {
 public:
  Camera(const Options& options, bool match)
      : faults_(options.faults),
        size_(options.size),
        match_(match),
        bits_(options.bits),
        shadow_key_(mix(options.seed + 81)),
        noise_key_(options.seed + (match ? 2 : 1)),
        noise_(
            std::sqrt(options.sensor_noise * options.sensor_noise + faults_.noise * faults_.noise)),
        spots_(spots(options, match)) {}

  void row(Image& image, int y) const {
    for (int x = 0; x < size_.width; ++x) {
      const double lit = share_of_light(x, y) * shadow(x, y);
      const double added = share_of_light(x, y) * reflection(x, y);
      for (std::size_t c = 0; c < image.planes.size(); ++c) {
        float& level = image.planes[c](y, x);
        level = static_cast<float>(sense(lit * level + added, c, y, x));
      }
    }
  }

 private:
  /// What the lens leaves of the light.
  double share_of_light(double x, double y) const {
    if (faults_.vignetting <= 0) return 1;
    const double cx = (size_.width - 1) / 2.0, cy = (size_.height - 1) / 2.0;
    const double r2 = (x - cx) * (x - cx) + (y - cy) * (y - cy);
    return 1 - faults_.vignetting * r2 / std::max(cx * cx + cy * cy, 1.0);
  }

  double shadow(double x, double y) const {
    if (faults_.shadow <= 0 || !match_) return 1;
    const double size = std::max(8.0, size_.height / 3.0);
    const double inside = (value_noise(shadow_key_, x / size, y / size) - 0.5) / 0.06 + 0.5;
    return 1 - faults_.shadow * smooth_step(inside);
  }

  double reflection(double x, double y) const {
    if (faults_.highlight <= 0) return 0;
    double brightest = 0;
    for (const Spot& spot : spots_) brightest = std::max(brightest, spot.at(x, y));
    return 255 * faults_.highlight * brightest;
  }

  double sense(double light, std::size_t channel, int y, int x) const {
    double level = match_ ? faults_.exposure * light + faults_.bias : light;
    if (noise_ > 0) level += noise_ * noise_at(noise_key_, channel, y, x);
    level = std::clamp(level, 0.0, 255.0);
    if (match_ && faults_.gamma != 1) level = 255 * power(level / 255, faults_.gamma);
    if (bits_ == 8) return std::floor(level + 0.5);
    if (bits_ == 16) return std::floor(level * 257 + 0.5) / 257;
    return level;
  }

  const Faults& faults_;
  cv::Size size_;
  bool match_;
  int bits_;
  std::uint64_t shadow_key_, noise_key_;
  double noise_;
  std::array<Spot, 6> spots_;
};

}  // namespace

void expose(Image& image, const Options& options, bool match) {
  const Camera camera(options, match);
  parallel_for(0, options.size.height, [&](int y) { camera.row(image, y); });
}

}  // namespace xgm::synthesis
