// SPDX-License-Identifier: Apache-2.0
#include "synthesis/coarse_dem.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/normal_noise.hpp"
#include "xgm/base/random.hpp"

namespace xgm::geo {

Raster coarse_dem(const SatelliteSceneSpec& spec, const Landscape& land, const MapFrame& frame) {
  constexpr std::uint64_t kError = 301;
  const int side = std::max(1, static_cast<int>(std::lround(spec.dem_posting / spec.posting)));
  const cv::Size size(land.heights.cols / side, land.heights.rows / side);
  Raster dem;
  dem.crs = with_heights(frame.crs(), spec.dem_datum);
  dem.place = {land.place.left, land.place.top, side * spec.posting, -side * spec.posting};
  dem.values.create(size);
  const CrsTransform to_datum(with_heights(frame.crs(), "ellipsoid"), dem.crs);
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      const double mean =
          cv::mean(land.heights(cv::Rect(column * side, row * side, side, side)))[0];
      const cv::Point2d centre = dem.place.centre(column, row);
      const double error = spec.dem_error * normal_noise(lattice_key(
                                                random_bits::mix(spec.seed + kError), column, row));
      dem.values(row, column) = static_cast<float>(to_datum.forward({centre.x, centre.y, mean})[2] +
                                                   spec.dem_bias + error);
    }
  }
  return dem;
}

}  // namespace xgm::geo
