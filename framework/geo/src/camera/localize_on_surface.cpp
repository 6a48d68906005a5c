// SPDX-License-Identifier: Apache-2.0
// Where a line of sight meets a surface: it is followed from above in steps of about half a sample,
// then the crossing is closed in on.
#include <algorithm>
#include <cmath>

#include "xgm/geo/camera/rpc_camera.hpp"

namespace xgm::geo {
namespace {

constexpr double kPrecision = 1e-4;  // m
constexpr double kMaxSteps = 20000;

/// The line of sight, by the heights of its points; straight between the ends.
class Sight {
 public:
  Sight(const GeoPoint& high, const GeoPoint& low) : high_(high), low_(low) {}

  GeoPoint at(double height) const {
    const double t =
        high_.height > low_.height ? (high_.height - height) / (high_.height - low_.height) : 0;
    return {high_.longitude + t * (low_.longitude - high_.longitude),
            high_.latitude + t * (low_.latitude - high_.latitude), height};
  }
  /// Horizontal distance of the ends, m.
  double run() const {
    return cv::norm(to_ecef({low_.longitude, low_.latitude, 0}) -
                    to_ecef({high_.longitude, high_.latitude, 0}));
  }

 private:
  GeoPoint high_, low_;
};

/// How far above the surface the sight is at a height; empty without data.
std::optional<double> clearance(const Sight& sight, double height, const HeightField& surface) {
  const GeoPoint point = sight.at(height);
  const auto ground = surface.height(point.longitude, point.latitude);
  return ground ? std::optional(height - *ground) : std::nullopt;
}

/// The sight is above the surface at `high` and not above it at `low`.
std::optional<double> close_in(const Sight& sight, double high, double low,
                               const HeightField& surface) {
  while (high - low > kPrecision) {
    const double middle = (high + low) / 2;
    const auto above = clearance(sight, middle, surface);
    if (!above) return std::nullopt;
    (*above > 0 ? high : low) = middle;
  }
  return (high + low) / 2;
}

}  // namespace

std::optional<GeoPoint> RpcCamera::localize(cv::Point2d pixel, const HeightField& surface) const {
  const HeightInterval bounds = surface.bounds();
  // A little beyond, so that a flat surface is crossed too.
  const double top = bounds.max + 1, bottom = bounds.min - 1;
  const auto high = localize(pixel, top), low = localize(pixel, bottom);
  if (!high || !low) return std::nullopt;
  const Sight sight(*high, *low);
  const double steps = std::clamp(std::ceil(2 * sight.run() / surface.posting()), 1.0, kMaxSteps);
  std::optional<double> before = clearance(sight, top, surface);
  for (double i = 1; i <= steps; ++i) {
    const double height = top + (bottom - top) * i / steps;
    const std::optional<double> here = clearance(sight, height, surface);
    if (here && *here <= 0) {
      if (!before || *before <= 0) return std::nullopt;  // it came in where there are no data
      const double last = top + (bottom - top) * (i - 1) / steps;
      const auto crossing = close_in(sight, last, height, surface);
      return crossing ? localize(pixel, *crossing) : std::nullopt;
    }
    before = here;
  }
  return std::nullopt;
}

}  // namespace xgm::geo
