// SPDX-License-Identifier: Apache-2.0
#include "options/scene_request.hpp"

#include "options/values.hpp"
#include "xgm/base/error.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/synthesis/plain_scene.hpp"

namespace xgm::cli {
namespace {

SceneFiles scene_files(const SceneOptions& options, const Registry& registry) {
  SceneFiles files;
  if (!options.scene.empty()) {
    files = find_scene(options.scene, registry, options.scene_name, options.dataset);
  } else {
    files.name = options.images.left;
    files.images = options.images;
  }
  if (!options.images.left_mask.empty()) files.images.left_mask = options.images.left_mask;
  if (!options.images.right_mask.empty()) files.images.right_mask = options.images.right_mask;
  const std::vector<double> no_data = parse_no_data(options.no_data, "--nodata");
  files.images.no_data.insert(files.images.no_data.end(), no_data.begin(), no_data.end());
  return files;
}

Scene sample_scene(const SceneOptions& options) {
  if (!options.images.left_mask.empty() || !options.images.right_mask.empty()) {
    throw UsageError("masks need images: give a SCENE_DIR, or --left and --right");
  }
  if (!options.no_data.empty()) {
    throw UsageError("--nodata needs images: give a SCENE_DIR, or --left and --right");
  }
  Scene scene = synthesis::sample_scene();
  scene.notes.push_back("no images were given: the built-in sample pair is matched (" +
                        std::to_string(scene.pair.size().width) + " x " +
                        std::to_string(scene.pair.size().height) + ")");
  return scene;
}

/// "min.pfm,max.pfm"
RangeMapFiles parse_range_maps(const std::string& text, const std::string& no_data) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || comma == 0 || comma + 1 == text.size() ||
      text.find(',', comma + 1) != std::string::npos) {
    throw UsageError("--range-maps " + text + ": write two file names, MIN.pfm,MAX.pfm");
  }
  return {text.substr(0, comma), text.substr(comma + 1), parse_no_data(no_data, "--nodata")};
}

TruthFiles truth_files(const SceneOptions& options) {
  return {.disparity = {options.truth, options.truth_divisor.value_or(0),
                        parse_no_data(options.truth_no_data, "--truth-nodata")},
          .non_occluded = options.truth_mask};
}

}  // namespace

SceneRequest scene_request(const SceneOptions& options, const Registry& registry) {
  SceneRequest request;
  request.disparities_from = "command line";
  if (!options.disparities.empty()) request.disparities = parse_disparities(options.disparities);
  if (!options.range_maps.empty())
    request.range_maps = parse_range_maps(options.range_maps, options.no_data);
  if (!options.truth.empty()) request.truth = truth_files(options);
  if (!options.memory_limit.empty()) {
    request.memory_limit = parse_bytes(options.memory_limit, "--memory-limit");
  }
  const bool has_files = !options.scene.empty() || !options.images.left.empty();
  if (has_files) {
    request.scene = scene_files(options, registry);
  } else {
    request.scene = sample_scene(options);
  }
  return request;
}

std::vector<NamedFile> files_beside_scene(const Registry& registry, const std::string& scene,
                                          const std::string& dataset) {
  std::vector<NamedFile> files;
  for (const std::string& file : plugin_files(registry)) files.push_back({"plugin file", file});
  for (const LoadFailure& failure : registry.failures()) {
    files.push_back({"plugin file", failure.file});
  }
  if (!scene.empty()) files.push_back({"data set", dataset_file(scene, dataset)});
  return files;
}

std::vector<NamedFile> files_read(const SceneOptions& options, const SceneRequest& request,
                                  const std::vector<Pipeline>& pipelines,
                                  const Registry& registry) {
  std::vector<NamedFile> files = files_of(request);
  for (const Pipeline& pipeline : pipelines) files.push_back({"pipeline", pipeline.file()});
  for (NamedFile& file : files_beside_scene(registry, options.scene, options.dataset)) {
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace xgm::cli
