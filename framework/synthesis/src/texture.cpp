// SPDX-License-Identifier: Apache-2.0
// Textures: noise as nature has it, and patterns with edges as people make them.
#include <algorithm>
#include <cmath>

#include "surface.hpp"
#include "xgm/base/random.hpp"
#include "xgm/synthesis/arithmetic.hpp"

namespace xgm::synthesis {
namespace {

using random_bits::mix;
using random_bits::unit;

/// Brightness 0 to 1, and how much of it each plane has more or less (about -0.5 to 0.5).
struct Paint {
  double brightness = 0.5;
  std::uint64_t cell = 0;  ///< parts of one colour share it; 0: none
};

double random_at(std::uint64_t key, double i, double j) {
  return unit(mix(mix(key ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(i))) ^
                  static_cast<std::uint64_t>(static_cast<std::int64_t>(j))));
}

/// From blobs down to detail of a few pixels: enough for a 3 x 3 window, little aliasing.
double plain_octaves(std::uint64_t key, cv::Point2d p) {
  constexpr std::array<double, 4> period{31.7, 13.3, 6.1, 3.2};
  constexpr std::array<double, 4> weight{0.3, 0.25, 0.25, 0.2};
  double sum = 0;
  for (std::size_t k = 0; k < period.size(); ++k)
    sum += weight[k] * value_noise(mix(key + k), p.x / period[k], p.y / period[k]);
  return sum;
}

/// Like natural images, coarse detail has more contrast than fine one.
double natural_octaves(std::uint64_t key, cv::Point2d p) {
  constexpr std::array<double, 5> period{83.0, 37.0, 16.3, 7.1, 3.4};
  constexpr std::array<double, 5> weight{0.3, 0.24, 0.18, 0.15, 0.13};
  double sum = 0;
  for (std::size_t k = 0; k < period.size(); ++k)
    sum += weight[k] * value_noise(mix(key + k), p.x / period[k] + 0.37, p.y / period[k] + 0.61);
  return std::clamp(0.5 + 1.6 * (sum - 0.5), 0.0, 1.0);
}

Paint bricks(const Texture& t, cv::Point2d p) {
  const double width = 34 * t.scale, height = 14 * t.scale, mortar = 1.6 * t.scale;
  const double row = std::floor(p.y / height);
  const double shifted = p.x / width + 0.5 * (row - 2 * std::floor(row / 2));
  const double column = std::floor(shifted);
  const double grain = natural_octaves(t.key, p) - 0.5;
  const bool joint = (shifted - column) * width < mortar || p.y - row * height < mortar;
  if (joint) return {0.85 + 0.25 * grain, 0};
  const double own = random_at(t.key + 11, column, row);
  return {0.2 + 0.35 * own + 0.4 * grain, mix(t.key + static_cast<std::uint64_t>(own * 1e6))};
}

/// Lines of "words": 5 x 7 dots a letter, of an alphabet of 24.
Paint letters(const Texture& t, cv::Point2d p) {
  const double dot = 1.7 * t.scale;
  const double column = std::floor(p.x / (6.5 * dot)), row = std::floor(p.y / (11 * dot));
  const double i = std::floor(p.x / dot - column * 6.5), j = std::floor(p.y / dot - row * 11);
  const double paper = 0.8 + 0.3 * (natural_octaves(t.key, p) - 0.5);
  const bool space = random_at(t.key + 21, column, row) < 0.18;
  if (space || i >= 5 || j >= 7) return {paper, 0};
  const double letter = std::floor(24 * random_at(t.key + 22, column, row));
  const bool ink = random_at(t.key + 23 + static_cast<std::uint64_t>(letter), i, j) < 0.5;
  return {ink ? 0.12 : paper, 0};
}

/// Patches of one colour each: the cells of the nearest of scattered points (Worley 1996).
Paint mosaic(const Texture& t, cv::Point2d p) {
  const double size = 19 * t.scale;
  const double x = p.x / size, y = p.y / size;
  double nearest = 1e9, cell_x = 0, cell_y = 0;
  for (double j = std::floor(y) - 1; j <= std::floor(y) + 1; ++j) {
    for (double i = std::floor(x) - 1; i <= std::floor(x) + 1; ++i) {
      const double dx = i + random_at(t.key + 31, i, j) - x;
      const double dy = j + random_at(t.key + 32, i, j) - y;
      if (dx * dx + dy * dy >= nearest) continue;
      nearest = dx * dx + dy * dy;
      cell_x = i;
      cell_y = j;
    }
  }
  const double own = random_at(t.key + 33, cell_x, cell_y);
  const double grain = natural_octaves(t.key, p) - 0.5;
  return {0.1 + 0.75 * own + 0.3 * grain, mix(t.key + static_cast<std::uint64_t>(own * 1e6))};
}

Paint wood(const Texture& t, cv::Point2d p) {
  const double s = t.scale;
  const double warp = value_noise(t.key + 41, p.x / (160 * s), p.y / (24 * s));
  const double rings = p.y / (11 * s) + 5 * warp;
  const double ring = std::abs(2 * (rings - std::floor(rings)) - 1);
  const double grain = value_noise(t.key + 42, p.x / (30 * s), p.y / 3.3);
  const double fine = value_noise(t.key + 43, p.x / 7.7, p.y / 3.6);
  return {0.15 + 0.35 * ring + 0.3 * grain + 0.2 * fine, 0};
}

Paint paint(const Texture& t, cv::Point2d p) {
  switch (t.kind) {
    case Texture::Kind::plain:
      return {plain_octaves(t.key, p), 0};
    case Texture::Kind::noise:
      return {natural_octaves(t.key, p), 0};
    case Texture::Kind::bricks:
      return bricks(t, p);
    case Texture::Kind::letters:
      return letters(t, p);
    case Texture::Kind::mosaic:
      return mosaic(t, p);
    case Texture::Kind::wood:
      return wood(t, p);
  }
  return {};
}

/// Difference in brightness of one plane, as a part of the contrast.
double tint(const Texture& t, const Paint& painted, cv::Point2d p, int channel) {
  const auto c = static_cast<std::uint64_t>(channel);
  if (t.kind == Texture::Kind::plain) return 0.2 * plain_octaves(mix(t.key + 101 + c), p) - 0.1;
  const double cell = painted.cell == 0 ? 0 : unit(mix(painted.cell + c)) - 0.5;
  const double drift = value_noise(t.key + 51 + c, p.x / 61, p.y / 61) - 0.5;
  return 0.35 * cell + 0.15 * drift;
}

/// How much of the contrast is left at a point.
double strength(const Texture& t, cv::Point2d p) {
  if (t.weak <= 0 || t.weak_share <= 0) return 1;
  if (t.weak_share >= 1) return 1 - t.weak;
  const double size = 48 * t.scale;
  const double noise = value_noise(t.key + 61, p.x / size, p.y / size);
  // Values near 0 and 1 are rare: this limit is above about the share asked for.
  const double limit = 0.12 + 0.76 * t.weak_share;
  return 1 - t.weak * smooth_step((limit - noise) / 0.06 + 0.5);
}

/// The same in every period: columns of blobs with sharp and soft edges.
double pattern(const Texture& t, cv::Point2d p) {
  const double x = p.x / t.period, y = p.y / t.period;
  const double fx = std::abs(2 * (x - std::floor(x)) - 1),
               fy = std::abs(2 * (y - std::floor(y)) - 1);
  return 0.75 * smooth_step(2 * fx - 0.5) + 0.25 * smooth_step(2 * fy - 0.5);
}

}  // namespace

Levels Texture::at(cv::Point2d p, int channels) const {
  const Paint painted = paint(*this, p);
  const double left = strength(*this, p);
  const double kind_share = kind == Kind::plain ? 0.8 : 1;  // the rest is the planes' own
  double brightness = kind_share * (painted.brightness - 0.5);
  if (repetitive > 0)
    brightness = (1 - repetitive) * brightness + repetitive * (pattern(*this, p) - 0.5);
  Levels levels{};
  for (int c = 0; c < channels; ++c) {
    double own = brightness;
    if (channels > 1 || kind == Kind::plain) own += (1 - repetitive) * tint(*this, painted, p, c);
    const auto i = static_cast<std::size_t>(c);
    levels[i] = level[i] + contrast * left * own;
  }
  return levels;
}

}  // namespace xgm::synthesis
