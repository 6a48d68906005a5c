// SPDX-License-Identifier: Apache-2.0
// The files of a surface, and what its record says of it.
#pragma once

#include "xgm/base/json.hpp"
#include "xgm/evaluation/run_folder.hpp"
#include "xgm/geo/run/recorded_surface.hpp"

namespace xgm::geo {

/// Of output_names(), those that not every run writes.
std::vector<std::string> optional_names();

void write_outputs(const SurfaceResult& result, const RunFolder& folder);

Json grid_json(const GridSpec& grid, const Raster& heights);
/// From where each image was taken, where the sun stood: null where it is not known.
Json images_json(const SurfaceResult& result);
Json pairs_json(const SurfaceResult& result);
/// How many cells there are, and the share of each reason and source.
Json cells_json(const SurfaceResult& result);

}  // namespace xgm::geo
