// SPDX-License-Identifier: Apache-2.0
// Which part of the images is matched, and on which grid the surface is made.
#pragma once

#include <vector>

#include "plugins/pipeline/surface/cloud.hpp"
#include "xgm/geo/stage/surface_family.hpp"

namespace xgm::geo {

/// The part of the base image that shows the requested area. Throws Error if it shows none of it.
cv::Rect window_of(const SurfaceRequest& request, const SatelliteImage& base);

/// Whether the second image shows some of the ground that the first one shows, at any height that
/// both cameras were made for.
bool overlap(const SatelliteImage& base, const SatelliteImage& match);

/// Windows of about the same size, none larger than `side`, that cover `whole`.
std::vector<cv::Rect> tiles(const cv::Rect& whole, int side);

/// UTM, with edges on multiples of the resolution; the requested area, or what the points cover.
/// Throws Error if there is neither.
GridSpec choose_grid(const SurfaceRequest& request, const std::vector<Cloud>& clouds,
                     double resolution);

}  // namespace xgm::geo
