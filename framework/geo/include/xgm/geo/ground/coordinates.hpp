// SPDX-License-Identifier: Apache-2.0
// Points on and above the ground, and the same points in the Cartesian frame of the Earth.
#pragma once

#include <opencv2/core.hpp>

#include "xgm/base/export.hpp"

namespace xgm::geo {

/// WGS 84 (EPSG:4979): degrees, degrees, and metres above the ellipsoid. Longitude comes first,
/// whatever the axis order of the CRS: east is x.
struct GeoPoint {
  double longitude = 0;
  double latitude = 0;
  double height = 0;
};

/// Earth-centred, Earth-fixed (EPSG:4978), m.
XGM_API cv::Vec3d to_ecef(const GeoPoint& point);
/// The inverse, to 1 nm for points within 10,000 km of the ellipsoid. Bowring's iteration: The
/// accuracy of geodetic latitude and height equations, Survey Review 28 (1985).
XGM_API GeoPoint to_geodetic(const cv::Vec3d& ecef);

/// Unit vectors to the east, to the north and up, at a point; columns of a matrix that takes local
/// coordinates to differences of ECEF.
XGM_API cv::Matx33d local_axes(const GeoPoint& point);

}  // namespace xgm::geo
