// SPDX-License-Identifier: Apache-2.0
// How two satellite images stand to each other.
#pragma once

#include <optional>

#include "xgm/geo/image/satellite_image.hpp"

namespace xgm::geo {

/// Empty: unknown.
struct PairFigures {
  std::optional<double> convergence;  ///< degrees between the sights of the middle of the first one
  std::optional<double> days;         ///< between the two
  std::optional<double> sun;          ///< degrees between the directions to the sun
  double overlap = 0;                 ///< share of the first image that the second one shows
};

XGM_API PairFigures pair_figures(const SatelliteImage& base, const SatelliteImage& match);

/// From where the middle of an image was seen.
XGM_API std::optional<ViewAngles> view_of(const SatelliteImage& image);

}  // namespace xgm::geo
