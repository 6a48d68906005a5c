// SPDX-License-Identifier: Apache-2.0
// What commands that match are asked: which pipeline, on which images, with which resources.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options/pipelines.hpp"
#include "xgm/data/scene_files.hpp"

namespace xgm::cli {

struct SceneOptions {
  std::string pipeline;
  std::string scene;       ///< folder
  std::string scene_name;  ///< of its scenes, the one to match
  std::string dataset;
  PairFiles images;
  std::string no_data;
  std::string disparities;
  std::string range_maps;
  std::vector<std::string> assignments;
  int threads = 0;
  std::string memory_limit;  ///< "2.5GB"; empty: none
  std::string truth;
  std::string truth_mask;
  std::optional<double> truth_divisor;
  std::string truth_no_data;
  std::string log_level = "info";
  PluginOptions plugins;
};

void add_pipeline(Command command, SceneOptions& options);
/// The scene's folder, or the images in its place.
void add_scene_or_images(Command command, SceneOptions& options);
/// In place of the scene's folder; returns --left.
Option add_images(Command command, SceneOptions& options);
/// Which of the scenes in the folder that `scene` takes, and how it is laid out.
void add_scene_choice(Command command, SceneOptions& options, Option scene);
/// --disparities.
Option add_interval(Command command, SceneOptions& options);
/// --disparities and --range-maps, which is returned.
Option add_search(Command command, SceneOptions& options);
/// --nodata, or --truth-nodata: values of `files` that mean none.
Option add_no_data_option(Command command, const std::string& name, std::string& values,
                          const std::string& files);
/// Parameters and threads.
void add_matching(Command command, SceneOptions& options);
void add_truth(Command command, SceneOptions& options);
/// Plugins and messages.
void add_surroundings(Command command, SceneOptions& options);
/// --log-level.
void add_log_level_option(Command command, std::string& level);

/// --dataset, for commands that take folders of scenes.
Option add_dataset_option(Command command, std::string& dataset);
/// --memory-limit, for commands that match.
void add_memory_limit_option(Command command, std::string& limit);
/// --threads.
void add_threads_option(Command command, int& threads,
                        const std::string& text = "Threads to use; without it all processors");

/// Those asked for, else all processors. What OpenCV does for stages is done by as many from now
/// on, in the whole program.
int use_threads(int threads);

}  // namespace xgm::cli
