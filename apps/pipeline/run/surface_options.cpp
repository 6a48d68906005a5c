// SPDX-License-Identifier: Apache-2.0
// Options of "pipeline run" that are for one family of pipelines only.
#include "options/pipelines.hpp"
#include "options/surfaces.hpp"
#include "run/run_surface.hpp"
#include "xgm/base/error.hpp"

namespace xgm::cli {
namespace {

void require_inputs(const Pipeline& pipeline, const RunCommandOptions& options) {
  const bool has_inputs =
      !options.satellites.images.empty() || !options.clouds.empty() || !options.scene.empty();
  if (!options.images.left.empty()) {
    throw UsageError(pipeline.file() +
                     ": makes surfaces of satellite images; give them as --images, not as --left "
                     "and --right");
  }
  if (has_inputs) return;
  throw UsageError(pipeline.file() +
                   ": makes surfaces of satellite images; give --images FILE FILE ..., a scene "
                   "in YAML, or --clouds FILE.ply ...");
}

void refuse_options_of_pairs(const RunCommandOptions& options) {
  refuse_for_surfaces({
      {"--cloud", !options.cloud.empty(),
       "a surface's points are always in DIR/cloud.ply; --clouds FILE.ply ... makes a surface of "
       "them again"},
      {"--tiles", !options.tiles.empty(),
       "satellite images are matched in windows anyway, whose size is --set tile=1000"},
      {"--disparities", !options.disparities.empty(),
       "heights bound the search: --dem FILE, or --set 'range_prior={type: fixed, lowest: 0, "
       "highest: 500}'"},
      {"--range-maps", !options.range_maps.empty(), "heights bound the search: --dem FILE"},
      {"--depth", !options.depth.empty(), "heights are in DIR/dsm.tif"},
      {"--dump", !options.dump.empty(), "maps of windows are not kept"},
      {"--explain", !options.explain.empty(), "DIR/reasons.tif says why cells are empty"},
      {"--memory-limit", !options.memory_limit.empty(),
       "smaller windows take less memory: --set tile=1000"},
      {"--left-mask", !options.images.left_mask.empty(), "give --masks, one per image"},
      {"--right-mask", !options.images.right_mask.empty(), "give --masks, one per image"},
      {"--nodata", !options.no_data.empty(), "name the value in the images (gdal_edit.py)"},
      {"--scene", !options.scene_name.empty(), "name the file of the scene"},
      {"--dataset", !options.dataset.empty(), "name the file of the scene"},
      {"--truth-divisor", options.truth_divisor.has_value(), "the truth is a raster of heights"},
      {"--truth-nodata", !options.truth_no_data.empty(),
       "name the value in the truth (gdal_edit.py)"},
      {"--truth-mask", !options.truth_mask.empty(),
       "take the heights out of the truth that are not to be judged"},
  });
}

void refuse_options_of_surfaces(const Pipeline& pipeline, const RunCommandOptions& options) {
  const bool given = options.satellites != SatelliteFiles{} || !options.clouds.empty() ||
                     !options.geoid.empty() || is_satellite_scene(options.scene);
  if (!given) return;
  throw UsageError(pipeline.file() +
                   ": matches one pair of images; scenes of satellite images, --images, --clouds, "
                   "--masks, --cameras, --dem, "
                   "--area, --band and --geoid are for pipelines of type surface, such as "
                   "dsm_tmgm16");
}

}  // namespace

bool is_surface(const Pipeline& pipeline, const RunCommandOptions& options) {
  const bool surface = makes_surfaces(pipeline);
  if (surface) {
    require_inputs(pipeline, options);
    refuse_options_of_pairs(options);
  } else {
    refuse_options_of_surfaces(pipeline, options);
  }
  return surface;
}

}  // namespace xgm::cli
