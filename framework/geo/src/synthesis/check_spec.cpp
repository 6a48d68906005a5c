// SPDX-License-Identifier: Apache-2.0
#include "synthesis/check_spec.hpp"

#include "xgm/base/error.hpp"
#include "xgm/base/text.hpp"

namespace xgm::geo {
namespace {

void check(const SatelliteView& view, const std::string& name) {
  require_within("azimuth" + name, view.azimuth, -360, 360);
  require_within("incidence" + name, view.incidence, 0, 50);
  require_within("heading" + name, view.heading, -360, 360);
  require_within("sun_azimuth" + name, view.sun_azimuth, -360, 360);
  require_within("sun_elevation" + name, view.sun_elevation, 5, 90);
  require_within("vegetation" + name, view.vegetation, 0.1, 3);
  require_within("date" + name, view.date, 0, 1e6);
  require_within("pointing_error" + name, view.pointing_error.x, -1000, 1000);
  require_within("pointing_error" + name, view.pointing_error.y, -1000, 1000);
}

}  // namespace

void require_within(const std::string& name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw UsageError("satellite scene: " + name + " is " + short_number(value) +
                   ", but must lie between " + short_number(low) + " and " + short_number(high));
}

void check(const SatelliteSceneSpec& spec) {
  if (spec.views.size() < 2) throw UsageError("satellite scene: give at least two views");
  require_within("longitude", spec.longitude, -180, 180);
  require_within("latitude", spec.latitude, -80, 84);
  require_within("size", spec.size, 64, 20000);
  require_within("gsd", spec.gsd, 0.1, 10);
  require_within("noise", spec.noise, 0, 1000);
  require_within("posting", spec.posting, 0.05, 10);
  require_within("lowest", spec.lowest, -400, 8000);
  require_within("relief", spec.relief, 0, 4000);
  require_within("flats", spec.flats, 0, 1);
  require_within("buildings", spec.buildings, 0, 1);
  require_within("woods", spec.woods, 0, 1);
  require_within("cars", spec.cars, 0, 1);
  require_within("relief_posting", spec.relief_posting, 0.05, 10);
  require_within("rpc_below", spec.rpc_below, 5, 5000);
  require_within("rpc_above", spec.rpc_above, 5, 5000);
  require_within("dem_posting", spec.dem_posting, spec.posting, 1000);
  require_within("dem_error", spec.dem_error, 0, 100);
  require_within("dem_bias", spec.dem_bias, -1000, 1000);
  with_heights(utm_crs(spec.longitude, spec.latitude), spec.dem_datum);  // throws if unknown
  for (std::size_t i = 0; i < spec.views.size(); ++i) {
    check(spec.views[i], " of view " + std::to_string(i + 1));
  }
}

}  // namespace xgm::geo
