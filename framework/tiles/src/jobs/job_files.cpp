// SPDX-License-Identifier: Apache-2.0
#include "jobs/job_files.hpp"

#include <filesystem>

#include "jobs/coarse_files.hpp"
#include "tiled_match.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/output_folder.hpp"

namespace xgm::tiles {
namespace {

/// What is found is a few numbers, so that the record itself holds them, with their hash.
StoredState state_of_found(const std::string& file, const std::string& question) {
  std::error_code unusable;
  if (!std::filesystem::exists(file, unusable)) return StoredState::missing;
  try {
    const Json record = Json::parse(read_file(file));
    if (record.at("question").text() != question) return StoredState::missing;
    const bool is_as_written = hash_text(record.at("found").dump()) == record.at("fnv1a64").text();
    return is_as_written ? StoredState::complete : StoredState::damaged;
  } catch (const Error&) {  // cut off
    return StoredState::damaged;
  }
}

}  // namespace

std::string jobs_folder(const JobManifest& manifest) {
  return (std::filesystem::path(manifest.file).parent_path() / kJobsFolder).string();
}

std::string result_file(const JobManifest& manifest, const TileJob& job) {
  return (std::filesystem::path(jobs_folder(manifest)) / (job.name + ".json")).string();
}

Json facts_of(const TileJob& job, double seconds) {
  return {{"job", job.name}, {"seconds", seconds}, {"peak_memory_bytes", peak_memory()}};
}

StoredState state_of_job(const JobManifest& manifest, const TileJob& job) {
  const std::string question = question_hash(manifest);
  if (job.name == kFit) return state_of_found(result_file(manifest, job), question);
  return state_of_result(jobs_folder(manifest), job.name, question);
}

bool is_done(const JobManifest& manifest, const TileJob& job) {
  const StoredState state =
      job.name == kCoarse ? state_of_coarse(manifest, job).state : state_of_job(manifest, job);
  return state == StoredState::complete;
}

void write_job_result(const JobManifest& manifest, const TileJob& job, const MatchResult& result,
                      double seconds) {
  const std::string folder = jobs_folder(manifest);
  make_output_folder(folder);
  write_result(folder, job.name, question_hash(manifest), result, facts_of(job, seconds));
}

MatchResult read_job_result(const JobManifest& manifest, const TileJob& job) {
  return read_result(jobs_folder(manifest), job.name);
}

void write_found(const JobManifest& manifest, const TileJob& job, const std::string& text,
                 double seconds) {
  const Json found = Json::parse(text);
  make_output_folder(jobs_folder(manifest));
  Json record = {{"question", question_hash(manifest)},
                 {"found", found},
                 {"fnv1a64", hash_text(found.dump())}};
  record.update(facts_of(job, seconds));
  const std::string file = result_file(manifest, job);
  write_file(file, record.dump(2) + "\n");
  sync_file(file);
}

std::string read_found(const JobManifest& manifest, const TileJob& job) {
  return Json::parse(read_file(result_file(manifest, job))).at("found").dump();
}

}  // namespace xgm::tiles
