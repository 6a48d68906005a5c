// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/synthesis/plan_views.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/check_spec.hpp"
#include "synthesis/normal_noise.hpp"
#include "xgm/base/random.hpp"

namespace xgm::geo {
namespace {

enum Key : std::uint64_t { kDates = 401, kImages, kPointing };

void check(const ViewPlan& plan) {
  require_within("number of images", plan.images, 2, 100);
  require_within("number of dates", plan.dates, 1, plan.images);
  require_within("incidence", plan.incidence, 0, 40);
  require_within("sun_elevation", plan.sun_elevation, 5, 80);
  require_within("pointing_error", plan.pointing_error, 0, 100);
}

/// What all images of a date share.
SatelliteView of_date(const ViewPlan& plan, std::uint64_t seed, int date) {
  Random random(random_bits::mix(seed + kDates + 1000 * static_cast<std::uint64_t>(date)));
  SatelliteView view;
  view.date = date;
  view.sun_azimuth = random.real(120, 180);
  view.sun_elevation = std::clamp(plan.sun_elevation + random.real(-8, 8), 5.0, 90.0);
  view.vegetation = random.real(0.75, 1.3);
  return view;
}

}  // namespace

std::vector<SatelliteView> plan_views(const ViewPlan& plan, std::uint64_t seed) {
  check(plan);
  const std::uint64_t noise = random_bits::mix(seed + kPointing);
  std::vector<SatelliteView> views;
  for (int i = 0; i < plan.images; ++i) {
    const auto number = static_cast<std::uint64_t>(i);
    Random random(random_bits::mix(seed + kImages + 1000 * number));
    SatelliteView& view = views.emplace_back(of_date(plan, seed, i % plan.dates));
    view.azimuth = std::fmod(10 + 360.0 * i / plan.images + random.real(-8, 8) + 360, 360);
    view.incidence = std::min(plan.incidence * random.real(0.8, 1.2), 50.0);
    view.heading = 190 + random.real(-4, 4);
    view.pointing_error = {
        plan.pointing_error * normal_noise(random_bits::mix(noise + 2 * number)),
        plan.pointing_error * normal_noise(random_bits::mix(noise + 2 * number + 1))};
  }
  return views;
}

}  // namespace xgm::geo
