// SPDX-License-Identifier: Apache-2.0
// Will a run fit into memory?
#pragma once

#include <optional>
#include <string>

#include "xgm/pipeline/pipeline.hpp"
#include "xgm/pipeline/plan.hpp"

namespace xgm::cli {

/// "2.5 GB", "800 MB"
std::string bytes_text(double bytes);

/// Compares what the run will take with `limit`, else with what is free, before any work. Above the
/// limit throws UsageError that says what to change; above what is free warns of it. From here on
/// running out of memory is an error, and not the end of the process.
void guard_memory(const Pipeline& pipeline, const MatchRequest& match, const PlanRequest& request,
                  std::optional<double> limit);

}  // namespace xgm::cli
