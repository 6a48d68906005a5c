// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/image/pair_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace xgm::geo {
namespace {

using Figure = std::optional<double>;

/// Share of one image, on a grid of places, that the other one shows, on ground of this height.
double overlap_at(double height, const SatelliteImage& a, const SatelliteImage& b) {
  constexpr int kSteps = 9;
  int shown = 0;
  for (int k = 0; k < kSteps * kSteps; ++k) {
    const cv::Point2d pixel((k % kSteps + 0.5) * a.size.width / kSteps,
                            (k / kSteps + 0.5) * a.size.height / kSteps);
    const auto point = a.camera.localize(pixel, height);
    if (!point || !b.camera.covers(*point, 0.5)) continue;
    const cv::Point2d there = b.camera.project(*point);
    shown += cv::Rect2d({}, cv::Size2d(b.size)).contains(there);
  }
  return shown / double{kSteps * kSteps};
}

/// The largest over the heights of the cameras, which may reach over kilometres where the ground
/// has one of them: crops of one place hardly overlap at others.
double overlap_of(const SatelliteImage& a, const SatelliteImage& b) {
  constexpr int kHeights = 17;
  const HeightInterval heights = common_heights(a.camera, b.camera);
  double most = 0;
  for (int i = 0; i < kHeights; ++i) {
    const double share = i / (kHeights - 1.0);
    most = std::max(most, overlap_at(heights.min + share * (heights.max - heights.min), a, b));
  }
  return most;
}

/// Angle of the sights that meet on the ground in the middle of the first image.
Figure convergence_of(const SatelliteImage& a, const SatelliteImage& b) {
  const cv::Point2d middle(a.size.width / 2.0, a.size.height / 2.0);
  const auto point = a.camera.localize(middle, a.camera.model().height.offset);
  if (!point) return std::nullopt;
  const auto one = a.camera.ray(middle), other = b.camera.ray(b.camera.project(*point));
  if (!one || !other) return std::nullopt;
  return angle_between(*one, *other);
}

Figure sun_between(const Acquisition& a, const Acquisition& b) {
  if (!a.sun_azimuth || !a.sun_elevation || !b.sun_azimuth || !b.sun_elevation) return std::nullopt;
  constexpr double kDegree = std::numbers::pi / 180;
  const auto direction = [](double azimuth, double elevation) {
    const double flat = std::cos(elevation * kDegree);
    return cv::Vec3d(flat * std::sin(azimuth * kDegree), flat * std::cos(azimuth * kDegree),
                     std::sin(elevation * kDegree));
  };
  const cv::Vec3d one = direction(*a.sun_azimuth, *a.sun_elevation);
  const cv::Vec3d other = direction(*b.sun_azimuth, *b.sun_elevation);
  return std::atan2(cv::norm(one.cross(other)), one.dot(other)) / kDegree;
}

}  // namespace

PairFigures pair_figures(const SatelliteImage& base, const SatelliteImage& match) {
  constexpr double kDay = 86400;  // s
  const Acquisition &a = base.acquisition, &b = match.acquisition;
  PairFigures figures{convergence_of(base, match), std::nullopt, sun_between(a, b),
                      overlap_of(base, match)};
  if (a.time && b.time) figures.days = std::abs(*a.time - *b.time) / kDay;
  return figures;
}

std::optional<ViewAngles> view_of(const SatelliteImage& image) {
  return image.camera.view_angles({image.size.width / 2.0, image.size.height / 2.0});
}

}  // namespace xgm::geo
