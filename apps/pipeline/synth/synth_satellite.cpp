// SPDX-License-Identifier: Apache-2.0
#include "synth/synth_satellite.hpp"

#include "options/values.hpp"
#include "xgm/base/error.hpp"

#ifdef XGM_HAS_GEO
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>

#include "xgm/geo/synthesis/plan_views.hpp"
#endif

namespace xgm::cli {
namespace {

void add_images(Command command, SatelliteOptions& options, Option satellite) {
  const auto add = [&](const std::string& name, auto& value, const std::string& type,
                       const std::string& help) {
    command.option(name, value, help).type_name(type).show_default().needs(satellite);
  };
  add("--images", options.images, "N", "Images of each scene");
  add("--dates", options.dates, "N",
      "Dates on which they were taken: sun, cars and vegetation differ");
  add("--incidence", options.incidence, "DEGREES", "Mean angle of the sights from straight above");
  add("--sun", options.sun, "DEGREES", "Mean elevation of the sun");
  add("--pointing-error", options.pointing_error, "PX",
      "Standard deviation of what the cameras say from what is true");
  add("--rpc-margin", options.rpc_margin, "M",
      "Heights that the cameras are good for below and above the ground");
  add("--gsd", options.gsd, "M", "Size of a pixel, and of the cells of the true surface");
  add("--noise", options.noise, "GREY", "Standard deviation of the noise, of 2047 grey levels");
}

void add_ground(Command command, SatelliteOptions& options, Option satellite) {
  const auto add = [&](const std::string& name, auto& value, const std::string& type,
                       const std::string& help) {
    command.option(name, value, help).type_name(type).show_default().needs(satellite);
  };
  add("--relief", options.relief, "M|FILE",
      "Height of the generated mountains, or a raster of heights in their place");
  add("--relief-posting", options.relief_posting, "M",
      "Size of a cell of that raster, if it has no georeference");
  add("--dem-posting", options.dem_posting, "M", "Size of a cell of the coarse DEM");
  add("--dem-error", options.dem_error, "M", "Standard deviation of its heights");
  add("--dem-bias", options.dem_bias, "M", "What is added to all of them");
  add("--dem-datum", options.dem_datum, "DATUM", "What they are counted from");
}

}  // namespace

void add_satellite_options(Command command, SatelliteOptions& options) {
  Option satellite =
      command.flag("--satellite", options.satellite,
                   "Satellite images with RPC cameras of mountains and flats with buildings and "
                   "trees, their exact surface and a coarse DEM");
  for (const char* name : {"--disparities", "--objects", "--fault", "--bits", "--grey"}) {
    satellite.excludes(command.find(name));
  }
  add_images(command, options, satellite);
  add_ground(command, options, satellite);
}

#ifdef XGM_HAS_GEO
namespace {

geo::SatelliteSceneSpec spec_of(const SatelliteOptions& options, int size, std::uint64_t seed) {
  geo::SatelliteSceneSpec spec;
  spec.seed = seed;
  spec.size = size;
  spec.gsd = spec.posting = options.gsd;
  spec.noise = options.noise;
  spec.rpc_below = spec.rpc_above = options.rpc_margin;
  spec.views = geo::plan_views({.images = options.images,
                                .dates = options.dates,
                                .incidence = options.incidence,
                                .sun_elevation = options.sun,
                                .pointing_error = options.pointing_error},
                               seed);
  if (const auto metres = parse_number(options.relief)) {
    spec.relief = *metres;
  } else if (std::filesystem::is_regular_file(options.relief)) {
    spec.relief_file = options.relief;
    spec.relief_posting = options.relief_posting;
  } else {
    throw UsageError("--relief " + options.relief + ": is neither a number of metres nor a file");
  }
  spec.dem_posting = options.dem_posting;
  spec.dem_error = options.dem_error;
  spec.dem_bias = options.dem_bias;
  spec.dem_datum = options.dem_datum;
  return spec;
}

}  // namespace

void check_satellites(const SatelliteOptions& options, int size, std::uint64_t seed) {
  geo::make_satellite_cameras(spec_of(options, size, seed));
}

std::string write_satellites(const std::string& folder, const SatelliteOptions& options, int size,
                             std::uint64_t seed) {
  const geo::SatelliteScene scene = geo::make_satellite_scene(spec_of(options, size, seed));
  geo::write_satellite_scene(folder, scene);
  const cv::Mat1f& heights = scene.surface.values;
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  return fmt::format("{} images of {} x {} px, heights {:.1f} to {:.1f} m", scene.images.size(),
                     size, size, *low, *high);
}
#else
void check_satellites(const SatelliteOptions&, int, std::uint64_t) {
  throw UsageError("--satellite: this program was built without GDAL and PROJ");
}

std::string write_satellites(const std::string&, const SatelliteOptions&, int, std::uint64_t) {
  return {};
}
#endif

}  // namespace xgm::cli
