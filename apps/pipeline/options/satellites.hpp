// SPDX-License-Identifier: Apache-2.0
// The options that say what a surface is made of.
#pragma once

#include <string>
#include <vector>

#include "command_line/command.hpp"

#ifdef XGM_HAS_GEO
#include "xgm/geo/run/surface_files.hpp"
#endif

namespace xgm::cli {

struct SatelliteFiles {
  std::vector<std::string> images, masks, cameras, dem;
  std::string area;
  int band = 0;

  bool operator==(const SatelliteFiles&) const = default;
};

/// Needs the argument "scene".
void add_satellite_files(Command command, SatelliteFiles& files);

#ifdef XGM_HAS_GEO
/// The files of a scene in YAML, unless its name is empty, those of the command line in their
/// place.
geo::SurfaceFiles surface_files(const std::string& scene, const SatelliteFiles& given);
#endif

}  // namespace xgm::cli
