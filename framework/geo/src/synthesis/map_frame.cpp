// SPDX-License-Identifier: Apache-2.0
#include "synthesis/map_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "xgm/base/parallel.hpp"

namespace xgm::geo {
namespace {
constexpr int kStep = 16;  // px
constexpr double kDegree = std::numbers::pi / 180;
const char* const kEcef = "EPSG:4978";
}  // namespace

MapFrame::MapFrame(double longitude, double latitude)
    : crs_(utm_crs(longitude, latitude)),
      to_map_(kEcef, with_heights(crs_, "ellipsoid")),
      to_geodetic_(kEcef, std::string(kWgs84)) {
  const CrsTransform to_grid("EPSG:4326", crs_);
  const cv::Vec3d a = to_grid.forward({longitude, latitude, 0});
  const cv::Vec3d b = to_grid.forward({longitude, latitude + 1e-3, 0});
  azimuth_shift_ = std::atan2(b[0] - a[0], b[1] - a[1]) / kDegree;
}

GeoPoint MapFrame::to_geodetic(const cv::Vec3d& ecef) const {
  const cv::Vec3d p = to_geodetic_.forward(ecef);
  return {p[0], p[1], p[2]};
}

cv::Vec3d MapFrame::at_height(const Ray& sight, double height) const {
  // From the Earth's sphere on; a secant step for each round.
  const double middle = -sight.origin.dot(sight.direction);
  const double inside = middle * middle - sight.origin.dot(sight.origin) + 6.37e6 * 6.37e6;
  double t = middle - std::sqrt(std::max(inside, 0.0));
  double before = t - 1000;
  double error_before = to_map_.forward(sight.origin + before * sight.direction)[2] - height;
  for (int round = 0; round < 10; ++round) {
    const double error = to_map_.forward(sight.origin + t * sight.direction)[2] - height;
    if (std::abs(error) < 1e-6) break;
    const double next = t - error * (t - before) / (error - error_before);
    before = t;
    error_before = error;
    t = next;
  }
  return sight.origin + t * sight.direction;
}

Sights::Sights(const PushbroomCamera& camera, const MapFrame& frame,
               const HeightInterval& heights) {
  const cv::Size size = camera.spec().size;
  high_.create(size.height / kStep + 2, size.width / kStep + 2);
  low_.create(high_.size());
  parallel_for(0, high_.rows, [&](int row) {
    for (int column = 0; column < high_.cols; ++column) {
      const Ray sight = camera.sight({(column - 0.5) * kStep, (row - 0.5) * kStep});
      high_(row, column) = frame.to_map(frame.at_height(sight, heights.max));
      low_(row, column) = frame.to_map(frame.at_height(sight, heights.min));
    }
  });
}

Sights::Segment Sights::at(cv::Point2d pixel) const {
  const double x = pixel.x / kStep + 0.5, y = pixel.y / kStep + 0.5;
  const int i = std::clamp(static_cast<int>(x), 0, high_.cols - 2);
  const int j = std::clamp(static_cast<int>(y), 0, high_.rows - 2);
  const double u = x - i, v = y - j;
  const auto blend = [&](const cv::Mat3d& m) {
    return (1 - v) * ((1 - u) * m(j, i) + u * m(j, i + 1)) +
           v * ((1 - u) * m(j + 1, i) + u * m(j + 1, i + 1));
  };
  return {blend(high_), blend(low_)};
}

}  // namespace xgm::geo
