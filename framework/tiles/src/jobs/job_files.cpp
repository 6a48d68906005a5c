// SPDX-License-Identifier: Apache-2.0
#include "jobs/job_files.hpp"

#include <filesystem>

#include "xgm/base/memory.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/io/stored_result.hpp"

namespace xgm::tiles {

std::string jobs_folder(const JobManifest& manifest) {
  return (std::filesystem::path(manifest.file).parent_path() / kJobsFolder).string();
}

void write_job_result(const JobManifest& manifest, const TileJob& job, const MatchResult& result,
                      double seconds) {
  const std::string folder = jobs_folder(manifest);
  make_output_folder(folder);
  write_result(folder, job.name, question_hash(manifest), result,
               {{"job", job.name}, {"seconds", seconds}, {"peak_memory_bytes", peak_memory()}});
}

MatchResult read_job_result(const JobManifest& manifest, const TileJob& job) {
  return read_result(jobs_folder(manifest), job.name);
}

bool is_done(const JobManifest& manifest, const TileJob& job) {
  return state_of_result(jobs_folder(manifest), job.name, question_hash(manifest)) ==
         StoredState::complete;
}

}  // namespace xgm::tiles
