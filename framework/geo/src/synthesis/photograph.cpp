// SPDX-License-Identifier: Apache-2.0
#include "synthesis/photograph.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/normal_noise.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/base/random.hpp"
#include "xgm/synthesis/arithmetic.hpp"

namespace xgm::geo {
namespace {

using random_bits::mix;

enum Key : std::uint64_t { kNoise = 201, kSoil, kGrain, kFields, kLeaves, kCars };
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kAmbient = 0.3;  // share of the light that comes from the sky
constexpr double kWhite = 1700;   // grey level of albedo 1 in full light
constexpr double kLevels = 2047;
constexpr double kLift = 0.02;   // m above the surface from which shadows are looked for
constexpr double kParking = 14;  // m between places where cars stand

/// Colours and light of one date.
class Scenery {
 public:
  Scenery(const SatelliteSceneSpec& spec, const SatelliteView& view, const Landscape& land,
          const HeightGrid& grid, double azimuth_shift)
      : spec_(spec), view_(view), land_(land), grid_(grid) {
    const double azimuth = (view.sun_azimuth + azimuth_shift) * kDegree;
    const double elevation = view.sun_elevation * kDegree;
    sun_ = {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
            std::sin(elevation)};
  }

  double grey(const cv::Vec3d& place) const {
    const HeightGrid::Point ground = grid_.at(place[0], place[1]);
    const cv::Vec3d up = cv::normalize(cv::Vec3d(-ground.slope_x, -ground.slope_y, 1));
    double light = std::max(0.0, up.dot(sun_));
    if (light > 0 && in_shadow({place[0], place[1], ground.height})) light = 0;
    return kWhite * albedo(place[0], place[1]) * (kAmbient + (1 - kAmbient) * light);
  }

 private:
  bool in_shadow(cv::Vec3d place) const {
    place[2] += kLift;
    const double up = (grid_.highest() + 1 - place[2]) / sun_[2];
    return grid_.first_hit(place, place + up * sun_).has_value();
  }

  double albedo(double x, double y) const {
    const cv::Point2d cell = land_.place.cell({x, y});
    const int column = std::clamp(cvRound(cell.x), 0, land_.cover.cols - 1);
    const int row = std::clamp(cvRound(cell.y), 0, land_.cover.rows - 1);
    const auto cover = static_cast<Cover>(land_.cover(row, column));
    if (cover == Cover::roof) return double{land_.roofs(row, column)};
    if (cover == Cover::tree) {
      const double leaves = fractal_noise(mix(spec_.seed + kLeaves), x, y, 4, 1);
      return std::clamp(view_.vegetation * (0.28 + 0.1 * leaves), 0.05, 1.0);
    }
    if (land_.flat(row, column) != 0) {
      if (const double car = car_at(x, y); car > 0) return car;
    }
    return soil(x, y);
  }

  double soil(double x, double y) const {
    const double broad = fractal_noise(mix(spec_.seed + kSoil), x, y, 60, 8);
    const double grain = fractal_noise(mix(spec_.seed + kGrain), x, y, 4, 1);
    const double grass =
        synthesis::smooth_step(0.5 + 3 * fractal_noise(mix(spec_.seed + kFields), x, y, 120, 60));
    const double gain = 1 + grass * (view_.vegetation - 1);
    return std::clamp(gain * (0.45 - 0.1 * grass + 0.13 * broad + 0.09 * grain), 0.05, 1.0);
  }

  /// Albedo of the car that stands at a place; 0: none.
  double car_at(double x, double y) const {
    const double i = std::floor(x / kParking), j = std::floor(y / kParking);
    Random random(
        lattice_key(mix(spec_.seed + kCars + 1000 * static_cast<std::uint64_t>(view_.date)),
                    static_cast<std::int64_t>(i), static_cast<std::int64_t>(j)));
    if (random.real(0, 1) >= spec_.cars) return 0;
    const double angle = random.real(0, std::numbers::pi);
    const double dx = x - (i + random.real(0.25, 0.75)) * kParking;
    const double dy = y - (j + random.real(0.25, 0.75)) * kParking;
    const double along = std::cos(angle) * dx + std::sin(angle) * dy;
    const double across = std::cos(angle) * dy - std::sin(angle) * dx;
    if (std::abs(along) > 2.2 || std::abs(across) > 0.9) return 0;
    return random.real(0, 1) < 0.5 ? random.real(0.06, 0.15) : random.real(0.7, 0.95);
  }

  const SatelliteSceneSpec& spec_;
  const SatelliteView& view_;
  const Landscape& land_;
  const HeightGrid& grid_;
  cv::Vec3d sun_;  // to the sun: east, north and up of the map
};

/// A camera around a place: over some metres it is affine to 1e-3 px, and the direction to the
/// satellite changes by 1e-5 only.
struct NearbyCamera {
  cv::Vec3d place;     // of the map
  cv::Point2d pixel;   // where it is seen
  cv::Matx23d slopes;  // px per m
  cv::Vec3d way;       // towards the satellite

  static std::optional<NearbyCamera> at(const PushbroomCamera& camera, const MapFrame& frame,
                                        const cv::Vec3d& place) {
    constexpr double kWay = 500, kAside = 10;  // m
    const cv::Vec3d ecef = frame.to_ecef(place);
    const auto pixel = camera.project(ecef);
    if (!pixel) return std::nullopt;
    NearbyCamera here{place, *pixel, {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
      cv::Vec3d aside = place;
      aside[axis] += kAside;
      const auto seen = camera.project(frame.to_ecef(aside));
      if (!seen) return std::nullopt;
      here.slopes(0, axis) = (seen->x - pixel->x) / kAside;
      here.slopes(1, axis) = (seen->y - pixel->y) / kAside;
    }
    here.way = frame.to_map(ecef - kWay * camera.sight(*pixel).direction) - place;
    return here;
  }

  cv::Point2d project(const cv::Vec3d& other) const {
    const cv::Vec2d moved = slopes * (other - place);
    return pixel + cv::Point2d(moved[0], moved[1]);
  }
};

}  // namespace

Photograph photograph(const SatelliteSceneSpec& spec, int number, const Landscape& land,
                      const HeightGrid& grid, const Sights& sights, const MapFrame& frame) {
  const Scenery scenery(spec, spec.views[static_cast<std::size_t>(number)], land, grid,
                        frame.azimuth_shift());
  Photograph photo{cv::Mat1w(spec.size, spec.size), cv::Mat1f(spec.size, spec.size)};
  const std::uint64_t noise = mix(spec.seed + kNoise + 1000 * static_cast<std::uint64_t>(number));
  const auto meet = [&](cv::Point2d pixel) -> std::optional<cv::Vec3d> {
    const Sights::Segment sight = sights.at(pixel);
    const auto share = grid.first_hit(sight.high, sight.low);
    if (!share) return std::nullopt;
    return sight.high + *share * (sight.low - sight.high);
  };
  parallel_for(0, spec.size, [&](int y) {
    for (int x = 0; x < spec.size; ++x) {
      const auto middle = meet(cv::Point2d(x, y));
      photo.heights(y, x) = middle ? static_cast<float>((*middle)[2]) : NAN;
      double grey = 0;
      for (const cv::Point2d part : {cv::Point2d(-0.25, -0.25), cv::Point2d(0.25, -0.25),
                                     cv::Point2d(-0.25, 0.25), cv::Point2d(0.25, 0.25)}) {
        if (const auto place = meet(cv::Point2d(x, y) + part)) grey += scenery.grey(*place) / 4;
      }
      grey += spec.noise * normal_noise(lattice_key(noise, x, y));
      photo.image(y, x) = static_cast<std::uint16_t>(std::clamp(std::round(grey), 0.0, kLevels));
    }
  });
  return photo;
}

cv::Mat1b visible_cells(const PushbroomCamera& camera, const Landscape& land,
                        const HeightGrid& grid, const MapFrame& frame) {
  const cv::Size size = land.heights.size();
  const cv::Rect2d image(-0.5, -0.5, camera.spec().size.width, camera.spec().size.height);
  cv::Mat1b visible(size, std::uint8_t{0});
  const auto place = [&](int column, int row) {
    const cv::Point2d centre = land.place.centre(column, row);
    return cv::Vec3d(centre.x, centre.y, double{land.heights(row, column)});
  };
  constexpr int kStep = 8;
  parallel_for(0, (size.height + kStep - 1) / kStep, [&](int block) {
    for (int left = 0; left < size.width; left += kStep) {
      const cv::Rect cells = cv::Rect(left, block * kStep, kStep, kStep) & cv::Rect({}, size);
      const auto here = NearbyCamera::at(camera, frame, place(left, block * kStep));
      if (!here) continue;
      for (int k = 0; k < cells.area(); ++k) {
        const int row = cells.y + k / cells.width, column = cells.x + k % cells.width;
        cv::Vec3d from = place(column, row);
        if (!image.contains(here->project(from))) continue;
        from[2] += kLift;
        const double up = (grid.highest() + 1 - from[2]) / here->way[2];
        visible(row, column) = grid.first_hit(from, from + up * here->way) ? 128 : 255;
      }
    }
  });
  return visible;
}

}  // namespace xgm::geo
