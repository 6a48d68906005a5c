// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/ground/coordinates.hpp"

#include <cmath>
#include <numbers>

namespace xgm::geo {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSemiMajor = 6378137;  // WGS 84, m
constexpr double kFlattening = 1 / 298.257223563;
constexpr double kSemiMinor = kSemiMajor * (1 - kFlattening);
constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);
constexpr double kSecondEccentricity2 = kEccentricity2 / (1 - kEccentricity2);

}  // namespace

cv::Vec3d to_ecef(const GeoPoint& point) {
  const double longitude = point.longitude * kDegree, latitude = point.latitude * kDegree;
  const double sine = std::sin(latitude), cosine = std::cos(latitude);
  const double curvature = kSemiMajor / std::sqrt(1 - kEccentricity2 * sine * sine);
  const double to_axis = (curvature + point.height) * cosine;
  return {to_axis * std::cos(longitude), to_axis * std::sin(longitude),
          (curvature * (1 - kEccentricity2) + point.height) * sine};
}

GeoPoint to_geodetic(const cv::Vec3d& ecef) {
  const double to_axis = std::hypot(ecef[0], ecef[1]);
  const double longitude = std::atan2(ecef[1], ecef[0]);
  // The parametric latitude, in terms of which the iteration converges within two rounds near the
  // Earth.
  double sine_u = ecef[2] * kSemiMajor, cosine_u = to_axis * kSemiMinor, latitude = 0;
  for (int round = 0; round < 3; ++round) {
    const double length = std::hypot(sine_u, cosine_u);
    if (length == 0) return {longitude / kDegree, 0, -kSemiMajor};  // the Earth's centre
    const double s = sine_u / length, c = cosine_u / length;
    latitude = std::atan2(ecef[2] + kSecondEccentricity2 * kSemiMinor * s * s * s,
                          to_axis - kEccentricity2 * kSemiMajor * c * c * c);
    sine_u = (1 - kFlattening) * std::sin(latitude);
    cosine_u = std::cos(latitude);
  }
  const double sine = std::sin(latitude), cosine = std::cos(latitude);
  // Stable everywhere: at the poles there is no distance to the axis, at the equator no z.
  const double height =
      to_axis * cosine + ecef[2] * sine - kSemiMajor * std::sqrt(1 - kEccentricity2 * sine * sine);
  return {longitude / kDegree, latitude / kDegree, height};
}

cv::Matx33d local_axes(const GeoPoint& point) {
  const double longitude = point.longitude * kDegree, latitude = point.latitude * kDegree;
  const double sl = std::sin(longitude), cl = std::cos(longitude);
  const double sp = std::sin(latitude), cp = std::cos(latitude);
  return {-sl, -sp * cl, cp * cl,  //
          cl,  -sp * sl, cp * sl,  //
          0,   cp,       sp};
}

}  // namespace xgm::geo
