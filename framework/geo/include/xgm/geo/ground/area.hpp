// SPDX-License-Identifier: Apache-2.0
// A part of the ground.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "xgm/geo/ground/raster.hpp"

namespace xgm::geo {

/// West, south, east, north, degrees.
using DegreeBox = cv::Vec4d;

/// Whether two boxes have more than an edge in common.
XGM_API bool intersect(const DegreeBox& a, const DegreeBox& b);
/// With longitude and latitude exchanged: what somebody has meant who wrote latitudes first.
XGM_API DegreeBox swapped(const DegreeBox& box);
/// "longitudes 55.64 to 55.66, latitudes -21.24 to -21.22"
XGM_API std::string to_string(const DegreeBox& box);
/// Bounds of the box in a CRS, whose x and y they are; its edges are curved there.
XGM_API cv::Rect2d box_in(const Crs& crs, const DegreeBox& box);
/// Bounds in degrees of a rectangle of a CRS.
XGM_API DegreeBox degrees_of(const Crs& crs, const cv::Rect2d& box);

/// Polygons, longitude and latitude in degrees. A place that lies in an odd number of the rings is
/// inside: holes are rings, too. No rings: everything is inside.
using Outline = std::vector<std::vector<cv::Point2d>>;

/// Bounds of all rings.
XGM_API DegreeBox bounds_of(const Outline& outline);
/// Cells whose centre lies outside of the outline become NaN. The raster has a CRS; edges are
/// straight lines there.
XGM_API void clear_outside(const Outline& outline, Raster& raster);

/// From a file: the polygons of a vector file that GDAL reads (GeoJSON, Shapefile, KML, ...), or
/// the four corners of a raster with a CRS. Throws UsageError, which names the file, if there are
/// none.
XGM_API Outline read_outline(const std::string& file);

}  // namespace xgm::geo
