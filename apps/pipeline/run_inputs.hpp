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
  Interval disparities;                ///< unless there are range maps
  std::string disparities_from;        ///< for people
  std::optional<double> memory_limit;  ///< bytes
};

/// Throws UsageError: no such folder, no disparity range, range maps that the pipeline cannot take.
Plan make_plan(const RunOptions& options, const Pipeline& pipeline, const Registry& registry);

struct Inputs {
  Scene scene;
  DisparityRange range;  ///< what lies beyond the image's width is cut off
};

/// Reads images, range maps and truth (that of --truth, else the scene's own), and tells what is
/// noteworthy. Throws Error.
Inputs read_inputs(const RunOptions& options, const Plan& plan);

}  // namespace xgm::cli
