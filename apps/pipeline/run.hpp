// SPDX-License-Identifier: Apache-2.0
// Parts of "pipeline run" that "pipeline explain" needs as well.
#pragma once

#include "run_options.hpp"
#include "xgm/io/scene.hpp"

namespace xgm::cli {

/// Adds the truth of --truth, if it was given, to the scene. Throws Error if it does not fit.
void read_truth(const RunOptions& options, Scene& scene);

/// From now on running out of memory is an error; warns if this range is likely to need more than
/// there is.
void guard_memory(const DisparityRange& range);

}  // namespace xgm::cli
