// SPDX-License-Identifier: Apache-2.0
// Writes results of a bench in the format that benchmarks expect for upload.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/evaluation/bench.hpp"

namespace xgm {

/// Writes the upload for a benchmark ("middlebury", "eth3d" or "kitti") to OUTPUT/submit/PIPELINE,
/// for pipelines that have finished all scenes. `method` is the name of the method if there is only
/// one pipeline; empty: the names of the pipelines. Returns the commands that pack the folders.
/// Throws Error if the scenes do not belong to the benchmark.
XGM_API std::vector<std::string> write_submission(const BenchResult& result,
                                                  const std::string& benchmark,
                                                  const std::string& method);
/// Throws, before any run, the Error that write_submission would throw.
XGM_API void check_submission(const BenchRequest& request, const std::string& benchmark,
                              const std::string& method);

}  // namespace xgm
