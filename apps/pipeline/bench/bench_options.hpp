// SPDX-License-Identifier: Apache-2.0
// What the user asked of "pipeline bench".
#pragma once

#include <string>
#include <vector>

#include "options/pipelines.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm::cli {

struct BenchOptions {
  std::vector<std::string> pipelines;
  std::vector<std::string> data;
  std::string dataset;
  std::vector<std::string> scenes;
  std::vector<std::string> assignments;
  std::vector<std::string> sweeps;
  BenchRules rules;  ///< but for thresholds and scale
  std::string thresholds;
  std::string scale = "1";
  int threads = 0;
  std::string memory_limit;
  bool fused = false;
  std::string output = "xgm_bench";
  std::string submit;
  std::string method;
  PluginOptions plugins;
};

void add_bench_options(Command command, BenchOptions& options);
/// Of these: the scenes, and what all runs on them have alike.
void add_bench_data(Command command, BenchOptions& options);
/// Of these: how maps are judged, but for the thresholds.
void add_bench_rules(Command command, BenchOptions& options);

/// The pipelines that were named; "all" is every shipped one. Throws UsageError.
std::vector<std::string> pipeline_names(const BenchOptions& options);
/// Throws UsageError.
BenchRules rules_of(const BenchOptions& options);

}  // namespace xgm::cli
