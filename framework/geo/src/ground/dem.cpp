// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/ground/dem.hpp"

#include <algorithm>
#include <cmath>

#include "xgm/base/error.hpp"
#include "xgm/geo/ground/coordinates.hpp"
#include "xgm/geo/ground/vertical_datum.hpp"

namespace xgm::geo {
namespace {

/// Distance of two samples, m.
double posting_of(const GridPlace& place, const CrsTransform& to_wgs84) {
  const cv::Vec3d a = to_wgs84.forward({place.centre(0, 0).x, place.centre(0, 0).y, 0});
  const cv::Vec3d b = to_wgs84.forward({place.centre(1, 0).x, place.centre(1, 1).y, 0});
  return cv::norm(to_ecef({a[0], a[1], 0}) - to_ecef({b[0], b[1], 0})) / std::sqrt(2.0);
}

HeightInterval bounds_of(const cv::Mat1d& heights, const std::string& name) {
  HeightInterval bounds{INFINITY, -INFINITY};
  for (const double height : heights) {
    if (std::isnan(height)) continue;
    bounds = {std::min(bounds.min, height), std::max(bounds.max, height)};
  }
  if (bounds.min > bounds.max) throw UsageError(name + ": this DEM has no heights here");
  return bounds;
}

}  // namespace

Dem::Dem(Raster raster, const std::string& name) : place_(raster.place) {
  if (raster.crs.empty())
    throw UsageError(name + ": this DEM has no CRS; assign one (gdal_edit.py)");
  try {
    if (!has_heights(raster.crs)) {
      throw UsageError(name + ": this DEM does not say what its heights are counted from; write " +
                       name + ",egm96 (SRTM) or " + name + ",ellipsoid");
    }
    const CrsTransform to_wgs84(raster.crs, std::string(kWgs84));
    heights_ = transformed_heights(raster, to_wgs84);
    posting_ = posting_of(place_, to_wgs84);
    if (!is_wgs84(raster.crs)) {
      to_grid_ = std::make_unique<CrsTransform>("EPSG:4326", horizontal(raster.crs));
    }
  } catch (const UsageError&) {
    throw;
  } catch (const Error& error) {  // of PROJ, which does not know the file
    throw UsageError(name + ": " + error.message());
  }
  bounds_ = bounds_of(heights_, name);
}

Dem::~Dem() = default;

std::optional<double> Dem::height(double longitude, double latitude) const {
  const cv::Vec3d here(longitude, latitude, 0);
  const cv::Vec3d place = to_grid_ ? to_grid_->forward(here) : here;
  const cv::Point2d cell = place_.cell({place[0], place[1]});
  const int x = static_cast<int>(std::floor(cell.x)), y = static_cast<int>(std::floor(cell.y));
  const double u = cell.x - x, v = cell.y - y;
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    const int column = x + k % 2, row = y + k / 2;
    const double weight = (k % 2 != 0 ? u : 1 - u) * (k / 2 != 0 ? v : 1 - v);
    if (weight == 0) continue;  // on the line of cells before
    if (column < 0 || row < 0 || column >= heights_.cols || row >= heights_.rows)
      return std::nullopt;
    sum += weight * heights_(row, column);
  }
  return std::isnan(sum) ? std::nullopt : std::optional(sum);
}

}  // namespace xgm::geo
