// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/synthesis/pushbroom_camera.hpp"

#include <cmath>
#include <numbers>

#include "xgm/base/random.hpp"
#include "xgm/geo/ground/crs.hpp"

namespace xgm::geo {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kEarthRadius = 6371008.8;       // mean, m
constexpr double kAltitude = 694000;             // m
constexpr double kGravity = 3.986004418e14;      // of the Earth, m^3 / s^2
constexpr double kEarthRotation = 7.292115e-5;   // rad / s
constexpr double kOrbitAzimuth = 192 * kDegree;  // of the flight: from north to south
constexpr double kGroundSpeed = 7000;            // m / s, at which lines are taken
// Of the optics: px at 5000 px from the middle are 1 and 2.
constexpr double kSquare = 1 / 2.5e7, kCube = 2 / 1.25e11;

struct Directions {
  cv::Vec3d east, north, up;
};

Directions directions(double longitude, double latitude) {
  const double sl = std::sin(longitude), cl = std::cos(longitude);
  const double sp = std::sin(latitude), cp = std::cos(latitude);
  return {{-sl, cl, 0}, {-sp * cl, -sp * sl, cp}, {cp * cl, cp * sl, sp}};
}

cv::Matx33d columns(const cv::Vec3d& x, const cv::Vec3d& y, const cv::Vec3d& z) {
  return {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]};
}

/// Rotation by a vector of some microradians; exact to its third power.
cv::Matx33d small_rotation(const cv::Vec3d& v) {
  const cv::Matx33d cross(0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0);
  return cv::Matx33d::eye() + cross + 0.5 * (cross * cross);
}

}  // namespace

PushbroomCamera::PushbroomCamera(const PushbroomSpec& spec) : spec_(spec) {
  const CrsTransform to_ecef(std::string(kWgs84), "EPSG:4978");
  target_ = to_ecef.forward({spec.target.longitude, spec.target.latitude, spec.target.height});
  const Directions here =
      directions(spec.target.longitude * kDegree, spec.target.latitude * kDegree);
  const double azimuth = spec.azimuth * kDegree, incidence = spec.incidence * kDegree;
  const cv::Vec3d seen_from =
      std::sin(incidence) * (std::sin(azimuth) * here.east + std::cos(azimuth) * here.north) +
      std::cos(incidence) * here.up;
  // Where the line of sight meets the orbit's sphere.
  const double along = target_.dot(seen_from), radius = kEarthRadius + kAltitude;
  const double range = -along + std::sqrt(along * along + radius * radius - target_.dot(target_));
  const cv::Vec3d satellite = target_ + range * seen_from;
  orbit_ = cv::norm(satellite);
  above_ = satellite * (1 / orbit_);
  const Directions there = directions(std::atan2(above_[1], above_[0]), std::asin(above_[2]));
  flight_ = std::sin(kOrbitAzimuth) * there.east + std::cos(kOrbitAzimuth) * there.north;
  const double heading = spec.heading * kDegree;
  forward_ = std::sin(heading) * here.east + std::cos(heading) * here.north;
  const double seen_along = forward_.dot(seen_from);
  step_ = spec.gsd / std::sqrt(1 - seen_along * seen_along);
  pixel_angle_ = spec.gsd / range;
  Random random(spec.seed);
  const std::array<double, 3> amplitude{6e-6, 6e-6, 50e-6};
  for (std::size_t i = 0; i < wobbles_.size(); ++i) {
    wobbles_[i] = {amplitude[i] * random.real(0.7, 1.3), random.real(2.5, 4),
                   random.real(0, 2 * std::numbers::pi)};
    still_[static_cast<int>(i)] = wobbles_[i].amplitude * std::sin(wobbles_[i].phase);
  }
}

cv::Vec3d PushbroomCamera::position(double time) const {
  const double angle = std::sqrt(kGravity / (orbit_ * orbit_ * orbit_)) * time;
  const cv::Vec3d p = orbit_ * (std::cos(angle) * above_ + std::sin(angle) * flight_);
  const double s = std::sin(kEarthRotation * time), c = std::cos(kEarthRotation * time);
  return {c * p[0] + s * p[1], c * p[1] - s * p[0], p[2]};
}

PushbroomCamera::Pose PushbroomCamera::pose(double row) const {
  const double rows = row - (spec_.size.height - 1) / 2.0;
  const double time = rows * spec_.gsd / kGroundSpeed;
  Pose pose{position(time), {}};
  const cv::Vec3d sight = cv::normalize(target_ + rows * step_ * forward_ - pose.position);
  const cv::Vec3d along = cv::normalize(forward_ - forward_.dot(sight) * sight);
  cv::Vec3d turn = -still_;
  for (int i = 0; i < 3; ++i) {
    const Wobble& w = wobbles_[static_cast<std::size_t>(i)];
    turn[i] += w.amplitude * std::sin(2 * std::numbers::pi * time / w.period + w.phase);
  }
  pose.axes = columns(along.cross(sight), along, sight) * small_rotation(turn);
  return pose;
}

double PushbroomCamera::angle_of(double column) const {
  const double u = column - (spec_.size.width - 1) / 2.0;
  return pixel_angle_ * u * (1 + kSquare * u + kCube * u * u);
}

double PushbroomCamera::column_of(double tangent) const {
  const double target = tangent / pixel_angle_;
  double u = target;
  for (int round = 0; round < 6; ++round) {
    const double error = u * (1 + kSquare * u + kCube * u * u) - target;
    u -= error / (1 + 2 * kSquare * u + 3 * kCube * u * u);
  }
  return u + (spec_.size.width - 1) / 2.0;
}

Ray PushbroomCamera::sight(cv::Point2d pixel) const {
  const Pose from = pose(pixel.y);
  return {from.position, cv::normalize(from.axes * cv::Vec3d(angle_of(pixel.x), 0, 1))};
}

std::optional<cv::Point2d> PushbroomCamera::project(const cv::Vec3d& ecef) const {
  constexpr int kMaxRounds = 30;
  double row = (spec_.size.height - 1) / 2.0;
  for (int round = 0; round < kMaxRounds; ++round) {
    const Pose from = pose(row);
    const cv::Vec3d seen = from.axes.t() * (ecef - from.position);
    const double rows = seen[1] / seen[2] / pixel_angle_;
    row += rows;
    if (std::abs(rows) < 1e-7) return cv::Point2d(column_of(seen[0] / seen[2]), row);
    if (!(std::abs(row) < 1e6)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace xgm::geo
