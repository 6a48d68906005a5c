// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/ground/vertical_datum.hpp"

#include <cmath>
#include <limits>

#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::geo {

Crs crs_with_heights(const Crs& crs, const std::map<std::string, std::string>& metadata) {
  if (crs.empty() || has_heights(crs)) return crs;
  const auto datum = metadata.find("vertical_datum");
  const bool is_ellipsoidal = datum != metadata.end() && datum->second == kEllipsoidalHeights;
  return is_ellipsoidal ? with_heights(crs, "ellipsoid") : crs;
}

cv::Mat1d transformed_heights(const Raster& raster, const CrsTransform& transform) {
  cv::Mat1d heights(raster.values.size(), std::numeric_limits<double>::quiet_NaN());
  parallel_for(0, heights.rows, [&](int row) {
    for (int column = 0; column < heights.cols; ++column) {
      const float value = raster.values(row, column);
      if (!std::isfinite(value)) continue;
      const cv::Point2d centre = raster.place.centre(column, row);
      heights(row, column) = transform.forward({centre.x, centre.y, double{value}})[2];
    }
  });
  return heights;
}

Raster above_geoid(const Raster& heights, const std::string& geoid) {
  Raster result = heights;
  result.crs = with_heights(horizontal(heights.crs), geoid);
  const CrsTransform transform(with_heights(horizontal(heights.crs), "ellipsoid"), result.crs);
  transformed_heights(heights, transform).convertTo(result.values, CV_32F);
  result.metadata["vertical_datum"] = heights_name(result.crs);
  return result;
}

void require_geoid(const std::string& geoid) {
  try {
    CrsTransform(std::string(kWgs84), with_heights("EPSG:4326", geoid));
  } catch (const Error& error) {
    throw UsageError("geoid " + geoid + ": " + error.message());
  }
}

}  // namespace xgm::geo
