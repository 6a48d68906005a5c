// SPDX-License-Identifier: Apache-2.0
// The results of jobs in files.
#pragma once

#include <string>

#include "xgm/io/stored_result.hpp"
#include "xgm/tiles/jobs.hpp"

namespace xgm::tiles {

inline constexpr const char* kJobsFolder = "jobs";

/// Where the results are.
std::string jobs_folder(const JobManifest& manifest);
/// That is there when the job is done.
std::string result_file(const JobManifest& manifest, const TileJob& job);

/// Of all that decides of the results.
std::string question_hash(const JobManifest& manifest);

/// What the record of a job says of it beside its results.
Json facts_of(const TileJob& job, double seconds);

/// Of any job but that of the coarse maps, see state_of_coarse().
StoredState state_of_job(const JobManifest& manifest, const TileJob& job);

/// The reverse map is kept if there is one. Throws Error.
void write_job_result(const JobManifest& manifest, const TileJob& job, const MatchResult& result,
                      double seconds);
/// Of a job that is done. Throws Error.
MatchResult read_job_result(const JobManifest& manifest, const TileJob& job);

/// The same of the job that looks at the whole scene: what it has found, as JSON.
void write_found(const JobManifest& manifest, const TileJob& job, const std::string& found,
                 double seconds);
std::string read_found(const JobManifest& manifest, const TileJob& job);

}  // namespace xgm::tiles
