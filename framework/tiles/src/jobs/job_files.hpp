// SPDX-License-Identifier: Apache-2.0
// The results of jobs in files.
#pragma once

#include <string>

#include "xgm/tiles/jobs.hpp"

namespace xgm::tiles {

inline constexpr const char* kJobsFolder = "jobs";

/// Where the results are.
std::string jobs_folder(const JobManifest& manifest);

/// Of all that decides of the results.
std::string question_hash(const JobManifest& manifest);

/// The reverse map is kept if there is one. Throws Error.
void write_job_result(const JobManifest& manifest, const TileJob& job, const MatchResult& result,
                      double seconds);
/// Of a job that is done. Throws Error.
MatchResult read_job_result(const JobManifest& manifest, const TileJob& job);

}  // namespace xgm::tiles
