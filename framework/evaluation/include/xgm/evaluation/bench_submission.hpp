// SPDX-License-Identifier: Apache-2.0
// Results of a bench as benchmarks want them uploaded.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm {

/// Writes what a benchmark wants uploaded ("middlebury", "eth3d" or "kitti") to
/// OUTPUT/submit/PIPELINE, for pipelines that are done on all scenes. `method` names the only
/// pipeline; empty: as they are called. Returns the commands that pack the folders. Throws Error if
/// the scenes are not such a benchmark's.
XGM_API std::vector<std::string> write_submission(const BenchResult& result,
                                                  const std::string& benchmark,
                                                  const std::string& method);
/// What write_submission would throw before any run.
XGM_API void check_submission(const BenchPlan& plan, const std::string& benchmark,
                              const std::string& method);

}  // namespace xgm
