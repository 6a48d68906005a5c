// SPDX-License-Identifier: Apache-2.0
// pipeline synth --satellite: images of a landscape with RPC cameras.
#pragma once

#include <cstdint>
#include <string>

#include "command_line/command.hpp"

namespace xgm::cli {

struct SatelliteOptions {
  bool satellite = false;
  int images = 2;
  int dates = 2;
  double incidence = 10;
  double sun = 45;
  double pointing_error = 0;
  std::string relief = "100";  ///< m, or a file of heights
  double relief_posting = 0.3;
  double rpc_margin = 60;
  double gsd = 0.5;
  double noise = 4;
  double dem_posting = 30;
  double dem_error = 2;
  double dem_bias = 0;
  std::string dem_datum = "ellipsoid";
};

void add_satellite_options(Command command, SatelliteOptions& options);

/// Throws UsageError for what is wrong with the options, before anything is written.
void check_satellites(const SatelliteOptions& options, int size, std::uint64_t seed);

/// Writes a scene of images of size x size px to a folder, and says what is in it in a line.
std::string write_satellites(const std::string& folder, const SatelliteOptions& options, int size,
                             std::uint64_t seed);

}  // namespace xgm::cli
