// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <limits>

#include "jobs/coarse_files.hpp"
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
    if (is_still(input.file, input.identity)) continue;
    throw Error(input.file + ": has changed since " + manifest.file +
                " was made; plan the jobs again");
  }
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// `rows`: of the coarse maps, that are needed.
void require_done(const JobManifest& manifest, const std::vector<std::string>& names,
                  cv::Range rows = cv::Range::all()) {
  const std::string remedy = " with pipeline tiles run " + manifest.file + " ";
  std::vector<std::string> missing;
  for (const std::string& name : names) {
    const TileJob& job = find_job(manifest, name);
    const CoarseState found =
        name == kCoarse ? state_of_coarse(manifest, job, rows)
                        : CoarseState{state_of_job(manifest, job), result_file(manifest, job)};
    if (found.state == StoredState::missing) missing.push_back(name);
    if (found.state != StoredState::damaged) continue;
    throw Error(found.file + ": this result, or a file that it names, is damaged; make it again" +
                remedy + name);
  }
  if (missing.empty()) return;
  throw Error("jobs that come first are not done: " + list(missing) + "; " +
              result_file(manifest, find_job(manifest, missing.front())) +
              " is missing or of another manifest; run them" + remedy + "JOB");
}

/// Does a job whose needs are done, and writes its result.
class JobRun {
 public:
  JobRun(const JobManifest& manifest, const TileJob& job, const Pipeline& pipeline,
         const RunOptions& options)
      : manifest_(manifest),
        job_(job),
        options_(with_facts(options, manifest.facts)),
        scale_(coarse_scale(pipeline, manifest.size, manifest.tiles)),
        match_(pipeline,
               {std::make_shared<const PairInFiles>(manifest.images, jobs_folder(manifest),
                                                    manifest.look),
                DisparityRange::uniform(manifest.size, manifest.disparities)},
               manifest.tiles) {}

  void run() {
    if (job_.name == kFit) {
      const std::string found = match_.find_on_whole(options_);
      write_found(manifest_, job_, found, seconds());
      return;
    }
    const MatchResult result = matched();
    if (job_.name == kCoarse) {
      // Tiles need those of their own rows and of the halo: half as high, little more is read.
      const int strip = std::max(1, manifest_.tiles.size.height / scale_ / 2);
      write_coarse(manifest_, job_, result, strip, seconds());
    } else {
      write_job_result(manifest_, job_, result, seconds());
    }
  }

 private:
  static RunOptions with_facts(RunOptions options, const RunFacts& facts) {
    options.facts = facts;
    return options;
  }

  MatchResult matched() {
    if (needs(kFit))
      match_.prepare_with(read_found(manifest_, find_job(manifest_, kFit)), options_);
    if (job_.name == kCoarse) {
      match_.match_coarse(options_);
      return match_.coarse();
    }
    if (needs(kCoarse)) {
      match_.use(read_coarse(manifest_, find_job(manifest_, kCoarse),
                             rows_needed(job_.place, manifest_.tiles, manifest_.size, scale_),
                             scale_));
    }
    return {match_.match(job_.place, options_), std::nullopt};
  }

  bool needs(const std::string& name) const {
    return std::find(job_.needs.begin(), job_.needs.end(), name) != job_.needs.end();
  }

  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

  const JobManifest& manifest_;
  const TileJob& job_;
  RunOptions options_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  int scale_;  ///< of the coarse maps
  TiledMatch match_;
};

}  // namespace

bool run_job(const JobManifest& manifest, const TileJob& job, const Pipeline& pipeline,
             const RunOptions& options) {
  if (is_done(manifest, job)) return false;
  require_unchanged(manifest);
  const int scale = coarse_scale(pipeline, manifest.size, manifest.tiles);
  require_done(manifest, job.needs, rows_needed(job.place, manifest.tiles, manifest.size, scale));
  JobRun(manifest, job, pipeline, options).run();
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
