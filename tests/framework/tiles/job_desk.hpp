// SPDX-License-Identifier: Apache-2.0
// A pair in files, the manifest of its jobs, and one process that matches the same.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "support/paths.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"
#include "xgm/io/map_in_parts.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/write_maps.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/synthesis/plain_scene.hpp"
#include "xgm/tiles/jobs.hpp"

namespace xgm::tiles {

using Names = std::vector<std::string>;

/// Rows of the pair are 0.8 px and more apart.
struct Desk : testing::TemporaryFolder {
  explicit Desk(const std::string& pipeline_name)
      : Desk(require_pipeline(XGM_SOURCE_DIR "/pipelines/" + pipeline_name + ".yaml",
                              testing::builtins())) {}
  explicit Desk(Pipeline asked) : pipeline(std::move(asked)) {
    const auto scene = synthesis::generate_plain({.size = {261, 171},
                                                  .disparities = {-6, 34},
                                                  .seed = 3,
                                                  .noise = 2,
                                                  .shift = {.b = 0.004, .c = 0.8}});
    files.images = {.left = *this / "left.png", .right = *this / "right.png"};
    write_png(files.images.left, picture(scene.pair.base));
    write_png(files.images.right, picture(scene.pair.match));
    plan();
  }
  void plan() {
    files.name = "generated";
    request.scene = files;
    request.disparities = Interval{-6, 34};
    request.scratch = path();
    manifest = plan_jobs(pipeline, read_scene(request, pipeline), files.images, cv::Size(128, 96),
                         *this / "work/manifest.json", {.threads = 1});
    write_manifest(manifest);
  }

  /// The files of the map, made by one process.
  void match_at_once(const std::string& folder) const {
    std::filesystem::create_directories(folder);
    const SceneInputs inputs = read_scene(request, pipeline);
    MapInParts map(folder, manifest.size, manifest.disparities, 1e12);
    run_in_tiles(pipeline, {inputs.scene.windows, inputs.range}, manifest.tiles,
                 [&](const cv::Rect& place, const DisparityMap& part) { map.take(place, part); });
    map.finish();
  }

  bool run(const std::string& job) const {
    return run_job(manifest, find_job(manifest, job), pipeline, {.threads = 1});
  }

  Pipeline pipeline;
  SceneFiles files;
  SceneRequest request;
  JobManifest manifest;
};

inline void check_same_files(const std::string& a, const std::string& b) {
  for (const char* name : kMapFiles) {
    CAPTURE(std::string(name));
    CHECK(read_file(a + "/" + name) == read_file(b + "/" + name));
  }
}

}  // namespace xgm::tiles
