// SPDX-License-Identifier: Apache-2.0
#include "synthesis/landscape.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/relief.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/base/random.hpp"
#include "xgm/synthesis/arithmetic.hpp"

namespace xgm::geo {
namespace {

using random_bits::mix;

/// Keys of what is random, so that no two are alike.
enum Key : std::uint64_t { kMountains = 1, kFlats, kRoughness };

/// Value that a share of all cells lies below.
float quantile(const cv::Mat1f& values, double share) {
  std::vector<float> sorted(values.begin(), values.end());
  const auto place =
      sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), place, sorted.end());
  return *place;
}

template <class At>
cv::Mat1f map_cells(const GridPlace& place, cv::Size size, const At& at) {
  cv::Mat1f values(size);
  parallel_for(0, size.height, [&](int row) {
    for (int column = 0; column < size.width; ++column) {
      const cv::Point2d centre = place.centre(column, row);
      values(row, column) = static_cast<float>(at(centre, row, column));
    }
  });
  return values;
}

/// Where `kind` lies above its quantile rise mountains; below it all is flat but for some bumps.
void make_ground(const SatelliteSceneSpec& spec, Landscape& land, cv::Size size) {
  const double extent = std::min(size.width, size.height) * spec.posting;
  const double wavelength = std::clamp(4 * spec.relief, extent / 4, extent);
  const cv::Mat1f kind = map_cells(land.place, size, [&](cv::Point2d p, int, int) {
    return fractal_noise(mix(spec.seed + kFlats), p.x, p.y, extent / 1.5, extent / 6);
  });
  const double shore = double{quantile(kind, spec.flats)};
  const auto rise = [&](int row, int column) {
    return synthesis::smooth_step((double{kind(row, column)} - shore) / 0.8);
  };
  land.heights = map_cells(land.place, size, [&](cv::Point2d p, int row, int column) {
    const double m = rise(row, column);
    if (m == 0) return 0.0;
    return m * (1 + 0.6 * fractal_noise(mix(spec.seed + kMountains), p.x, p.y, wavelength,
                                        wavelength / 64, 0.4));
  });
  land.flat = cv::Mat1b(kind <= static_cast<float>(shore));
  const double highest = double{*std::max_element(land.heights.begin(), land.heights.end())};
  const double bumps = std::min(0.4, spec.relief / 10);
  const double gain = highest > 0 ? (spec.relief - 2 * bumps) / highest : 0;
  land.heights = map_cells(land.place, size, [&](cv::Point2d p, int row, int column) {
    const double bump = fractal_noise(mix(spec.seed + kRoughness), p.x, p.y, 25, 3);
    return spec.lowest + bumps + gain * double{land.heights(row, column)} +
           bumps * std::clamp(bump, -1.0, 1.0);
  });
}

}  // namespace

std::uint64_t lattice_key(std::uint64_t key, std::int64_t i, std::int64_t j) {
  return mix(mix(key ^ static_cast<std::uint64_t>(i)) ^ static_cast<std::uint64_t>(j));
}

double fractal_noise(std::uint64_t key, double x, double y, double wavelength, double finest,
                     double falls) {
  double sum = 0, weight = 1;
  for (double length = wavelength; length >= finest; length /= 2, weight *= falls) {
    key = mix(key);
    // Lattices of octaves do not share their lines.
    const double shift = 0.37 * length;
    sum +=
        weight * (2 * synthesis::value_noise(key, (x + shift) / length, (y - shift) / length) - 1);
  }
  return sum;
}

HeightInterval ground_heights(const SatelliteSceneSpec& spec) {
  if (spec.relief_file.empty()) return {spec.lowest, spec.lowest + spec.relief + kHighestObject};
  const Raster relief = read_relief(spec);
  const float highest = *std::max_element(relief.values.begin(), relief.values.end());
  return {spec.lowest, spec.lowest + double{highest}};
}

Landscape make_landscape(const SatelliteSceneSpec& spec, const GridPlace& place, cv::Size size) {
  Landscape land{.heights = {},
                 .cover = cv::Mat1b(size, static_cast<std::uint8_t>(Cover::ground)),
                 .roofs = cv::Mat1f(size, 0.0F),
                 .flat = {},
                 .place = place};
  if (spec.relief_file.empty()) {
    make_ground(spec, land, size);
    add_buildings(spec, land);
    add_trees(spec, land);
  } else {
    take_relief(spec, land);
  }
  return land;
}

}  // namespace xgm::geo
