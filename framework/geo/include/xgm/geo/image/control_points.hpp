// SPDX-License-Identifier: Apache-2.0
// Points whose place on the ground was surveyed, and where images show them.
#pragma once

#include <string>
#include <vector>

#include "xgm/geo/ground/coordinates.hpp"

namespace xgm::geo {

struct ControlPoint {
  std::string name;
  std::string image;  ///< a file name; its folder and its ending do not count
  cv::Point2d pixel;  ///< (0, 0) is the centre of the first pixel
  GeoPoint ground;
};

/// By the ending of the file:
/// - .geojson, .json: features of type Point [longitude, latitude, height above the ellipsoid],
/// with the
///   properties "ji" ([column, row]), "filename" and, if wanted, "id";
/// - .csv: a first line that names the columns: image, column, row, longitude, latitude, height
/// and, if
///   wanted, name; in any order.
/// Throws Error, which names the file and the point.
XGM_API std::vector<ControlPoint> read_control_points(const std::string& file);

}  // namespace xgm::geo
