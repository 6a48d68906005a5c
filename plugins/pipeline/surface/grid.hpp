// SPDX-License-Identifier: Apache-2.0
// Which part of the images is matched, and on which grid the surface is made.
#pragma once

#include <vector>

#include "xgm/geo/image/point_cloud.hpp"
#include "xgm/geo/stage/surface_family.hpp"

namespace xgm::geo {

/// The part of the base image that shows the requested area; empty if it shows none of it.
cv::Rect window_of(const SurfaceRequest& request, const SatelliteImage& base);

/// Whether the second image shows some of the ground that the first one shows, at any height that
/// both cameras were made for.
bool overlap(const SatelliteImage& base, const SatelliteImage& match);

/// Length of a pixel on the ground, m, in steps of 5 cm.
double ground_pixel(const SatelliteImage& image);

/// Cells of `step` m of a grid around what is wanted of an image, about.
double cells_shown(const SurfaceRequest& request, const SatelliteImage& image, double step);

/// The zone of UTM in the middle of the requested area, or of the points, which are in degrees.
/// Throws Error if there is neither.
Crs choose_crs(const std::optional<cv::Vec4d>& area, const std::vector<PointCloud>& clouds);

/// Cells of `step` m with edges on multiples of it, for the requested area, or for all points,
/// which are in the CRS. Throws Error if there is neither.
GridSpec choose_grid(const std::optional<cv::Vec4d>& area, const Crs& crs,
                     const std::vector<PointCloud>& clouds, double step);

}  // namespace xgm::geo
