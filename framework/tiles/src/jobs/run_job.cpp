// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <limits>

#include "jobs/job_files.hpp"
#include "tiled_match.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/map_in_parts.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/io/pair_in_files.hpp"

namespace xgm::tiles {
namespace {

void require_unchanged(const JobManifest& manifest) {
  for (const InputFile& input : manifest.inputs) {
    const FileIdentity now = identify_file(input.file);
    if (now.bytes == input.identity.bytes && now.fnv1a64 == input.identity.fnv1a64) continue;
    throw Error(input.file + ": has changed since " + manifest.file +
                " was made; plan the jobs again");
  }
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void require_done(const JobManifest& manifest, const std::vector<std::string>& names) {
  std::vector<std::string> missing;
  for (const std::string& name : names) {
    if (!is_done(manifest, find_job(manifest, name))) missing.push_back(name);
  }
  if (missing.empty()) return;
  throw Error("jobs that come first are not done: " + list(missing) +
              "; run them with pipeline tiles run " + manifest.file + " JOB");
}

MatchResult matched(const JobManifest& manifest, const TileJob& job, const Pipeline& pipeline,
                    const RunOptions& options) {
  auto pair = std::make_shared<const PairInFiles>(manifest.images, jobs_folder(manifest));
  TiledMatch match(pipeline, {pair, DisparityRange::uniform(pair->size(), manifest.disparities)},
                   manifest.tiles);
  match.prepare(options);
  if (job.place.empty()) {
    match.match_coarse(options);
    return match.coarse();
  }
  if (match.has_coarse()) {
    match.use(read_job_result(manifest, find_job(manifest, job.needs.front())));
  }
  return {match.match(job.place, options), std::nullopt};
}

}  // namespace

bool run_job(const JobManifest& manifest, const TileJob& job, const Pipeline& pipeline,
             const RunOptions& options) {
  if (is_done(manifest, job)) return false;
  require_unchanged(manifest);
  require_done(manifest, job.needs);
  const auto begin = std::chrono::steady_clock::now();
  const MatchResult result = matched(manifest, job, pipeline, options);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  write_job_result(manifest, job, result, taken.count());
  return true;
}

MapSummary join_jobs(const JobManifest& manifest, const std::string& folder) {
  std::vector<std::string> names;
  for (const TileJob& job : manifest.jobs) {
    if (!job.place.empty()) names.push_back(job.name);
  }
  require_done(manifest, names);
  make_output_folder(folder);
  MapInParts map(folder, manifest.size, manifest.disparities,
                 std::numeric_limits<double>::infinity());
  for (const std::string& name : names) {
    const TileJob& job = find_job(manifest, name);
    map.take(job.place, read_job_result(manifest, job).forward);
  }
  map.finish();
  return map.summary();
}

}  // namespace xgm::tiles
