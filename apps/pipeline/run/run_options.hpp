// SPDX-License-Identifier: Apache-2.0
// What the user asked of "pipeline run".
#pragma once

#include <string>
#include <vector>

#include "options/scene_options.hpp"

namespace xgm::cli {

struct RunCommandOptions : SceneOptions {
  std::string output = "xgm_output";
  std::string dump;
  bool report = false;
  std::string tiles;  ///< "auto" or "WIDTHxHEIGHT"; empty: as one
  bool resume = false;
  std::string cache;
  std::string cache_size = "10GB";
  std::string cloud;
  std::string depth;
  std::vector<std::string> explain;  ///< "X,Y" or "every=N"
  std::vector<std::string> satellite_images;
  std::vector<std::string> satellite_clouds;
  std::vector<std::string> satellite_masks;
  std::vector<std::string> satellite_cameras;
  std::vector<std::string> dem;
  std::string area;
  int band = 0;
  std::string geoid;
};

void add_run_options(Command command, RunCommandOptions& options);

}  // namespace xgm::cli
