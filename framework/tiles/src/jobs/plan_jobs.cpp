// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "choose_tiles.hpp"
#include "stereo_family.hpp"
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

PairLook look_of(const SceneInputs& inputs) {
  const auto* const files = dynamic_cast<const PairInFiles*>(inputs.scene.windows.get());
  if (files == nullptr) throw UsageError("jobs need images that are read by windows");
  return files->look();
}

/// Jobs that match are given the same memory. The job that looks at the whole scene is there if
/// stages may do so; no other one looks then.
std::vector<TileJob> jobs_of(const TiledMatch& match, bool has_fit, const TilePlan& plan,
                             const TileOptions& tiles) {
  const double bytes = plan.bytes(tiles);
  std::vector<TileJob> jobs;
  std::vector<std::string> before;
  const auto add_before = [&](const char* name, double memory, double seconds) {
    jobs.push_back({.name = name, .needs = before, .memory_bytes = memory, .seconds = seconds});
    before.emplace_back(name);
  };
  if (has_fit) add_before(kFit, plan.fit().bytes, plan.fit().seconds);
  if (match.has_coarse()) add_before(kCoarse, bytes, matching_seconds(plan.coarse(tiles)));
  const double seconds = matching_seconds(plan.tile(tiles));
  const std::vector<cv::Rect> parts = match.parts();
  const std::vector<std::string> names = names_of(parts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    jobs.push_back({.name = names[i],
                    .needs = before,
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
  JobManifest manifest{
      .file = file,
      .pipeline_file = pipeline.file(),
      .pipeline = pipeline.resolved_json(),
      .facts = {.scene = inputs.scene.name, .calibration = inputs.scene.calibration},
      .images = absolute(images),
      .look = look_of(inputs),
      .inputs = inputs.scene.inputs,
      .size = inputs.scene.size(),
      .disparities = inputs.range.hull(),
      .tiles = tiles,
      .threads = options.threads > 0 ? options.threads : thread_count()};
  for (InputFile& input : manifest.inputs) {
    input.file = std::filesystem::absolute(input.file).string();
  }
  manifest.jobs = jobs_of(match, stereo_family(pipeline).looks_at_whole(), plan, tiles);
  return manifest;
}

}  // namespace xgm::tiles
