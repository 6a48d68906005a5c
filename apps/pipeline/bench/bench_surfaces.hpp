// SPDX-License-Identifier: Apache-2.0
// pipeline bench with pipelines that make surfaces.
#pragma once

#include "bench/bench_options.hpp"

namespace xgm::cli {

/// Throws UsageError for what is wrong before any run.
int bench_surfaces(const BenchOptions& options, const Registry& registry,
                   std::vector<BenchPipeline> pipelines);

}  // namespace xgm::cli
