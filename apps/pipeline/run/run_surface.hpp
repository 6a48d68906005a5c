// SPDX-License-Identifier: Apache-2.0
// pipeline run with satellite images.
#pragma once

#include "run/run_options.hpp"
#include "terminal/progress.hpp"
#include "xgm/evaluation/keeping.hpp"

namespace xgm::cli {

/// Whether the pipeline makes surfaces of satellite images. Throws UsageError if it is given what
/// only pipelines of the other family take.
bool is_surface(const Pipeline& pipeline, const RunCommandOptions& options);

int run_surface(const Pipeline& pipeline, const Registry& registry,
                const RunCommandOptions& options, const KeepRequest& keep,
                const std::vector<std::string>& command_line, const RunOptions& run,
                Progress& progress);

}  // namespace xgm::cli
