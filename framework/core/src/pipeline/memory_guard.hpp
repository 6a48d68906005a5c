// SPDX-License-Identifier: Apache-2.0
// Will a run fit into memory?
#pragma once

#include <optional>
#include <string>

#include "xgm/pipeline/plan.hpp"

namespace xgm {

/// Compares what the run will take with `limit` (bytes), else with what is free, before any work.
/// Above the limit throws UsageError that says what to change; above what is free returns a warning
/// of it. Otherwise "". `options` are those of the run.
std::string guard_memory(const Pipeline& pipeline, const MatchRequest& match,
                         const PlanRequest& request, std::optional<double> limit,
                         const RunOptions& options);

}  // namespace xgm
