// SPDX-License-Identifier: Apache-2.0
// What the user asked of "pipeline eval".
#pragma once

#include <optional>
#include <string>

#include "options/pipelines.hpp"
#include "xgm/evaluation/metrics.hpp"

namespace xgm::cli {

/// A value of --clip: 0 to ndisp of the scene.
inline constexpr const char* kNdisp = "ndisp";

struct EvalOptions {
  std::string map;    ///< file, or output folder of a run
  std::string scene;  ///< folder
  std::string scene_name;
  std::string dataset;
  PluginOptions plugins;
  std::optional<double> divisor;
  std::string no_data;
  std::string truth;
  std::optional<double> truth_divisor;
  std::string truth_no_data;
  std::string mask;
  std::string objects;
  std::string confidence;
  std::string thresholds;
  double scale = 1;
  std::string clip;
  std::string json;
  std::string csv;
  bool surface = false;
  std::string source;  ///< of the surface's heights
};

void add_eval_options(Command command, EvalOptions& options);

/// Rules without clip. Throws UsageError.
EvaluationRules parse_rules(const EvalOptions& options);

/// --clip, where `bound` is what the scene says. Throws UsageError.
Interval parse_clip(const std::string& text, const std::optional<Interval>& bound);

}  // namespace xgm::cli
