// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "choose_tiles.hpp"
#include "tiled_match.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/tiles/jobs.hpp"

namespace xgm::tiles {
namespace {

/// Jobs may run in another folder than the one they were planned in.
PairFiles absolute(PairFiles images) {
  for (std::string* file : {&images.left, &images.right, &images.left_mask, &images.right_mask}) {
    if (!file->empty()) *file = std::filesystem::absolute(*file).string();
  }
  return images;
}

/// All are given the same memory: what prepares the images, before the
/// coarse levels and before each tile, is in the plan of a tile.
std::vector<TileJob> jobs_of(const std::vector<cv::Rect>& parts, bool has_coarse,
                             const TilePlan& plan, const TileOptions& tiles) {
  const double bytes = plan.bytes(tiles), seconds = plan.tile(tiles).seconds;
  std::vector<TileJob> jobs;
  if (has_coarse) {
    jobs.push_back({.name = kCoarse, .memory_bytes = bytes, .seconds = plan.coarse(tiles).seconds});
  }
  const std::vector<std::string> names = names_of(parts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    jobs.push_back(
        {.name = names[i],
         .needs = has_coarse ? std::vector<std::string>{kCoarse} : std::vector<std::string>{},
         .place = parts[i],
         .memory_bytes = bytes,
         .seconds = seconds});
  }
  return jobs;
}

}  // namespace

JobManifest plan_jobs(const Pipeline& pipeline, const SceneInputs& inputs, const PairFiles& images,
                      std::optional<cv::Size> size, const std::string& file,
                      const RunOptions& options) {
  if (!inputs.range.is_uniform()) {
    throw UsageError("jobs search one range in all of the image; give --disparities MIN:MAX");
  }
  const TiledRequest request{inputs.scene.windows, inputs.range};
  const Besides besides{.held = inputs.scene.windows_bytes};
  const TilePlan plan(pipeline, request, besides, options, PlanOf::memory_and_seconds);
  const TileOptions tiles =
      size ? tiles_of_size(*size) : fitting(plan, inputs.scene.size(), inputs.memory_limit.value());
  const TiledMatch match(pipeline, request, tiles);
  JobManifest manifest{.file = file,
                       .pipeline_file = pipeline.file(),
                       .pipeline = pipeline.resolved_json(),
                       .images = absolute(images),
                       .inputs = inputs.scene.inputs,
                       .size = inputs.scene.size(),
                       .disparities = inputs.range.hull(),
                       .tiles = tiles,
                       .threads = options.threads > 0 ? options.threads : thread_count()};
  for (InputFile& input : manifest.inputs) {
    input.file = std::filesystem::absolute(input.file).string();
  }
  manifest.jobs = jobs_of(match.parts(), match.has_coarse(), plan, tiles);
  return manifest;
}

}  // namespace xgm::tiles
