// SPDX-License-Identifier: Apache-2.0
// What the user asked of "pipeline run".
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm::cli {

struct RunOptions {
  std::string pipeline;
  std::string scene;       ///< folder
  std::string scene_name;  ///< of its scenes, the one to match
  std::string dataset;
  PairFiles images;
  std::string disparities;
  std::string range_maps;
  std::string output = "xgm_output";
  std::vector<std::string> assignments;
  int threads = 0;
  std::string dump;
  std::string log_level = "info";
  std::string truth;
  std::string truth_mask;
  bool report = false;
  std::string memory_limit;  ///< "2.5GB"; empty: none
  std::optional<double> truth_divisor;
  std::string cloud;
  std::string depth;
  std::vector<std::string> explain;  ///< "X,Y" or "every=N"
  PluginOptions plugins;
};

void add_run_options(CLI::App& command, RunOptions& options);
/// The same but for what is written; `place` takes "[SCENE_DIR] X Y".
void add_explain_options(CLI::App& command, RunOptions& options, std::vector<std::string>& place);
/// What they match, and nothing that is written; `pipeline` takes several, separated by commas.
void add_speed_options(CLI::App& command, RunOptions& options);

/// Those of a run that matter to its memory and time, and --size.
void add_plan_options(CLI::App& command, RunOptions& options, std::string& size);

/// Those asked for, else all processors.
int threads_of(const RunOptions& options);

/// "min.pfm,max.pfm". Throws UsageError.
std::pair<std::string, std::string> parse_range_maps(const std::string& text);

}  // namespace xgm::cli
