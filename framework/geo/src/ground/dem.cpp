// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/ground/dem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/geo/ground/coordinates.hpp"

namespace xgm::geo {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Heights of all cells above the ellipsoid.
cv::Mat1d ellipsoidal(const Raster& raster, const CrsTransform& to_wgs84) {
  cv::Mat1d heights(raster.values.size(), kNone);
  parallel_for(0, heights.rows, [&](int row) {
    for (int column = 0; column < heights.cols; ++column) {
      const float value = raster.values(row, column);
      if (!std::isfinite(value)) continue;
      const cv::Point2d centre = raster.place.centre(column, row);
      heights(row, column) = to_wgs84.forward({centre.x, centre.y, value})[2];
    }
  });
  return heights;
}

HeightInterval bounds_of(const cv::Mat1d& heights, const std::string& name) {
  HeightInterval bounds{INFINITY, -INFINITY};
  for (const double height : heights) {
    if (std::isnan(height)) continue;
    bounds = {std::min(bounds.min, height), std::max(bounds.max, height)};
  }
  if (bounds.min > bounds.max) throw Error(name + ": this DEM has no heights");
  return bounds;
}

}  // namespace

Dem::Dem(Raster raster, const std::string& name) : place_(raster.place) {
  if (raster.crs.empty())
    throw UsageError(name + ": this DEM has no CRS; assign one (gdal_edit.py)");
  if (!has_heights(raster.crs)) {
    throw UsageError(name + ": this DEM does not say what its heights are counted from; write " +
                     name + ",egm96 (SRTM) or " + name + ",ellipsoid");
  }
  const CrsTransform to_wgs84(raster.crs, std::string(kWgs84));
  heights_ = ellipsoidal(raster, to_wgs84);
  bounds_ = bounds_of(heights_, name);
  if (!is_wgs84(raster.crs)) {
    to_grid_ = std::make_unique<CrsTransform>("EPSG:4326", horizontal(raster.crs));
  }
  const cv::Vec3d a = to_wgs84.forward({place_.centre(0, 0).x, place_.centre(0, 0).y, 0});
  const cv::Vec3d b = to_wgs84.forward({place_.centre(1, 0).x, place_.centre(1, 1).y, 0});
  posting_ = cv::norm(to_ecef({a[0], a[1], 0}) - to_ecef({b[0], b[1], 0})) / std::sqrt(2.0);
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

std::string dem_file(const std::string& file) {
  return std::filesystem::exists(file) ? file : file.substr(0, file.rfind(','));
}

std::shared_ptr<const Dem> read_dem(const std::string& file) {
  const std::string name = dem_file(file);
  const std::string datum = name.size() < file.size() ? file.substr(name.size() + 1) : "";
  Raster raster = read_raster(name);
  if (!datum.empty()) {
    if (raster.crs.empty())
      throw UsageError(name + ": this DEM has no CRS; assign one (gdal_edit.py)");
    raster.crs = with_heights(raster.crs, datum);
  } else if (!raster.crs.empty() && !has_heights(raster.crs) &&
             raster.metadata["vertical_datum"] == kEllipsoidalHeights) {
    raster.crs = with_heights(raster.crs, "ellipsoid");
  }
  return std::make_shared<const Dem>(std::move(raster), name);
}

}  // namespace xgm::geo
