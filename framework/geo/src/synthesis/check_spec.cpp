// SPDX-License-Identifier: Apache-2.0
#include "synthesis/check_spec.hpp"

#include "xgm/base/error.hpp"
#include "xgm/base/text.hpp"

namespace xgm::geo {
namespace {

void within(const std::string& name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw UsageError("satellite scene: " + name + " is " + short_number(value) +
                   ", but must lie between " + short_number(low) + " and " + short_number(high));
}

void check(const SatelliteView& view, const std::string& name) {
  within("azimuth" + name, view.azimuth, -360, 360);
  within("incidence" + name, view.incidence, 0, 50);
  within("heading" + name, view.heading, -360, 360);
  within("sun_azimuth" + name, view.sun_azimuth, -360, 360);
  within("sun_elevation" + name, view.sun_elevation, 5, 90);
  within("vegetation" + name, view.vegetation, 0.1, 3);
  within("date" + name, view.date, 0, 1e6);
  within("pointing_error" + name, view.pointing_error.x, -1000, 1000);
  within("pointing_error" + name, view.pointing_error.y, -1000, 1000);
}

}  // namespace

void check(const SatelliteSceneSpec& spec) {
  if (spec.views.size() < 2) throw UsageError("satellite scene: give at least two views");
  within("longitude", spec.longitude, -180, 180);
  within("latitude", spec.latitude, -80, 84);
  within("size", spec.size, 64, 20000);
  within("gsd", spec.gsd, 0.1, 10);
  within("noise", spec.noise, 0, 1000);
  within("posting", spec.posting, 0.05, 10);
  within("lowest", spec.lowest, -400, 8000);
  within("relief", spec.relief, 0, 4000);
  within("flats", spec.flats, 0, 1);
  within("buildings", spec.buildings, 0, 1);
  within("woods", spec.woods, 0, 1);
  within("cars", spec.cars, 0, 1);
  within("relief_posting", spec.relief_posting, 0.05, 10);
  within("rpc_below", spec.rpc_below, 5, 5000);
  within("rpc_above", spec.rpc_above, 5, 5000);
  within("dem_posting", spec.dem_posting, spec.posting, 1000);
  within("dem_error", spec.dem_error, 0, 100);
  within("dem_bias", spec.dem_bias, -1000, 1000);
  for (std::size_t i = 0; i < spec.views.size(); ++i) {
    check(spec.views[i], " of view " + std::to_string(i + 1));
  }
}

}  // namespace xgm::geo
