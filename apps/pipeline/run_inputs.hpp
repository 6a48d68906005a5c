// SPDX-License-Identifier: Apache-2.0
// From the command line to what is matched: the scene and its search range.
#pragma once

#include <optional>
#include <string>

#include "run_options.hpp"
#include "xgm/io/scene.hpp"

namespace xgm::cli {

/// Decided before any image is opened.
struct Plan {
  std::optional<SceneFiles> scene;  ///< without it the sample pair
  std::optional<std::pair<std::string, std::string>> range_maps;
  Interval disparities;          ///< unless there are range maps
  std::string disparities_from;  ///< for people
};

/// Throws UsageError: no such folder, no disparity range, range maps that the pipeline cannot take.
Plan make_plan(const RunOptions& options, const Pipeline& pipeline, const Registry& registry);

/// Opens the images. Throws Error.
Scene read_scene(const Plan& plan);

/// The range to search in this scene: range maps are read and added to its inputs; what lies beyond
/// the image's width is cut off, with a warning. Throws Error if nothing is left.
DisparityRange make_range(const Plan& plan, Scene& scene);

}  // namespace xgm::cli
