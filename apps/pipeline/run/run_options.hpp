// SPDX-License-Identifier: Apache-2.0
// What the user asked of "pipeline run".
#pragma once

#include <string>
#include <vector>

#include "options/satellites.hpp"
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
  SatelliteFiles satellites;
  std::vector<std::string> clouds;  ///< of earlier runs
  std::string geoid;
};

void add_run_options(Command command, RunCommandOptions& options);

}  // namespace xgm::cli
