// SPDX-License-Identifier: Apache-2.0
// The generated ground and what stands on it.
#pragma once

#include <cstdint>

#include "xgm/geo/ground/raster.hpp"
#include "xgm/geo/synthesis/satellite_scene.hpp"

namespace xgm::geo {

enum class Cover : std::uint8_t { ground, tree, roof };

struct Landscape {
  cv::Mat1f heights;  ///< m, of all cells
  cv::Mat1b cover;    ///< Cover
  cv::Mat1f roofs;    ///< albedo of roofs, which have no texture
  cv::Mat1b flat;     ///< 255 on flats
  GridPlace place;
};

/// What stands on generated ground is no higher, m.
inline constexpr double kHighestObject = 30;

/// Heights that the ground and what stands on it can have.
HeightInterval ground_heights(const SatelliteSceneSpec& spec);

/// Mountains and flats with buildings and trees; or the relief of a file, which is mirrored at its
/// borders where the grid is larger.
Landscape make_landscape(const SatelliteSceneSpec& spec, const GridPlace& place, cv::Size size);

/// Adds buildings and trees to the ground (landscape_objects.cpp).
void add_buildings(const SatelliteSceneSpec& spec, Landscape& land);
void add_trees(const SatelliteSceneSpec& spec, Landscape& land);

/// Random numbers of a place on a lattice, the same whatever the grid.
std::uint64_t lattice_key(std::uint64_t key, std::int64_t i, std::int64_t j);

/// Noise of several octaves around 0, about -1 to 1; from `wavelength` down to `finest`, m, each
/// with `falls` of the one before.
double fractal_noise(std::uint64_t key, double x, double y, double wavelength, double finest,
                     double falls = 0.5);

}  // namespace xgm::geo
