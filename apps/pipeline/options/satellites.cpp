// SPDX-License-Identifier: Apache-2.0
#include "options/satellites.hpp"

#include <type_traits>

namespace xgm::cli {

void add_satellite_files(Command command, SatelliteFiles& files) {
  command
      .option("--images", files.images,
              "For pipelines of type surface: satellite images with RPC cameras, in their files or "
              "beside them; or a scene in YAML in place of SCENE_DIR, whose values the options "
              "below replace")
      .type_name("FILE...")
      .excludes(command.find("scene"));
  command
      .option("--masks", files.masks,
              "One per image: not 0 where it may be used (no cloud, no water)")
      .type_name("FILE...");
  command
      .option("--cameras", files.cameras,
              "One per image: the vendor's file with its RPC, in place of what the image holds")
      .type_name("FILE...");
  command
      .option("--dem", files.dem,
              "Known heights that bound the search: tiles, or a folder of them. DATUM if a file "
              "does not say what heights are counted from: egm96 (SRTM), egm2008, ellipsoid, "
              "EPSG:CODE")
      .type_name("FILE[,DATUM]...");
  command
      .option("--area", files.area,
              "Part of the ground to be matched: degrees; a window of the first image, px; a file "
              "with a polygon (GeoJSON, Shapefile, KML), or a raster. Without it, what the first "
              "image of each pair shows, or all points of the clouds")
      .type_name("WEST,SOUTH,EAST,NORTH|COLUMN,ROW:WIDTHxHEIGHT|FILE");
  constexpr int kMaxBands = 10000;
  command
      .option("--band", files.band,
              "Which band of the images is matched, from 1 on; without it the mean of all")
      .type_name("N")
      .range(1, kMaxBands);
}

#ifdef XGM_HAS_GEO
geo::SurfaceFiles surface_files(const std::string& scene, const SatelliteFiles& given) {
  geo::SurfaceFiles files;
  if (!scene.empty()) files = geo::read_surface_scene(scene);
  const auto replace = [](auto& value, const auto& other) {
    if (other != std::decay_t<decltype(other)>{}) value = other;
  };
  replace(files.images, given.images);
  replace(files.masks, given.masks);
  replace(files.cameras, given.cameras);
  replace(files.dem, given.dem);
  replace(files.area, given.area);
  replace(files.band, given.band);
  return files;
}
#endif

}  // namespace xgm::cli
