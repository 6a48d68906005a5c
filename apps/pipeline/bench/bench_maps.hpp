// SPDX-License-Identifier: Apache-2.0
// Benches of maps: what is run, and how.
#pragma once

#include <vector>

#include "bench/bench_options.hpp"
#include "terminal/progress.hpp"

namespace xgm::cli {

/// All runs of these pipelines, checked. Throws Error.
BenchRequest bench_request(const BenchOptions& options, const Registry& registry,
                           std::vector<BenchPipeline> pipelines, const BenchRules& rules);

/// A process for each run, told on the terminal. What is given outlives the hooks.
BenchHooks bench_hooks(const BenchOptions& options, int threads, Progress& progress);

}  // namespace xgm::cli
