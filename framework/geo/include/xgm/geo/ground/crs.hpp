// SPDX-License-Identifier: Apache-2.0
// Coordinate reference systems, and the way from one to another.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "xgm/base/export.hpp"

namespace xgm::geo {

/// A coordinate reference system in any text that PROJ understands: "EPSG:32740", WKT.
using Crs = std::string;

inline constexpr std::string_view kWgs84 =
    "EPSG:4979";  ///< longitude, latitude, ellipsoidal height

/// What heights above the ellipsoid are called.
inline constexpr std::string_view kEllipsoidalHeights = "WGS 84 ellipsoid";

/// A name for what heights are counted from: "ellipsoid", "egm96", "egm2008", or the code of a
/// vertical CRS ("EPSG:5773"). Throws UsageError for others.
XGM_API Crs with_heights(const Crs& horizontal, const std::string& vertical_datum);
/// Whether the CRS says what heights are counted from: a compound CRS, or one of three dimensions.
/// Throws Error if PROJ does not know it.
XGM_API bool has_heights(const Crs& crs);
/// Whether it has heights and they are those above its ellipsoid.
XGM_API bool has_ellipsoidal_heights(const Crs& crs);
/// The CRS without its heights.
XGM_API Crs horizontal(const Crs& crs);
/// Whether coordinates are longitude and latitude on WGS 84, heights or not.
XGM_API bool is_wgs84(const Crs& crs);
/// Whether coordinates are lengths on a map, heights or not. Throws Error if PROJ does not know it.
XGM_API bool is_projected(const Crs& crs);
/// "WGS 84 / UTM zone 40S"
XGM_API std::string crs_name(const Crs& crs);
/// 32740 of "WGS 84 / UTM zone 40S", heights or not; none if EPSG has no such CRS.
XGM_API std::optional<int> epsg_code(const Crs& crs);
/// What the heights of a CRS are counted from: "EGM96 height", or "WGS 84 ellipsoid".
XGM_API std::string heights_name(const Crs& crs);
/// The zone of UTM on WGS 84 that a place lies in: "EPSG:32740".
XGM_API Crs utm_crs(double longitude, double latitude);

/// Coordinates of one CRS as those of another. East (x, longitude) comes first on both sides,
/// whatever the axis order of the CRS; degrees, m. Only transformations that PROJ knows exactly are
/// used: where a grid is missing it does not quietly leave a geoid out.
class XGM_API CrsTransform {
 public:
  /// Throws Error if there is no such transformation; it names the missing grid.
  CrsTransform(const Crs& from, const Crs& to);
  ~CrsTransform();
  CrsTransform(const CrsTransform&) = delete;
  CrsTransform& operator=(const CrsTransform&) = delete;

  /// Safe to use from several threads. Throws Error for a point that lies outside of the CRS.
  cv::Vec3d forward(const cv::Vec3d& point) const;
  cv::Vec3d inverse(const cv::Vec3d& point) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace xgm::geo
