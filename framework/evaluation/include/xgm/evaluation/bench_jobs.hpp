// SPDX-License-Identifier: Apache-2.0
// The runs of a bench, whatever they make: which of them are done already, and the order of the
// others.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/base/json.hpp"

namespace xgm {

enum class CellState { not_run, failed, done };

/// "done", "failed" or "not run"
XGM_API const char* state_text(CellState state);

/// The log of a run, in its folder.
inline constexpr const char* kCellLog = "log.txt";

/// The outcome of one run.
struct RunOutcome {
  bool interrupted = false;
  std::string failure;  ///< empty if the run succeeded
};

/// One run. It is done if an earlier bench ran a job of this folder and identity, and run.json and
/// `result` in the folder have not changed since.
struct BenchJob {
  std::string pipeline, scene;  ///< for the progress
  std::string folder;           ///< of the run's files
  std::string identity;         ///< JSON: all that decides what the run gives
  std::string result;           ///< the file that is judged, in the folder: "disparity.pfm"
};

/// What a finished job tells of itself.
struct JobFigures {
  std::string failure{};  ///< why it failed; else empty
  double seconds = 0;
  double peak_bytes = 0;
};

/// The progress of a bench.
struct BenchProgress {
  std::size_t number = 0;  ///< of the job, counted from 1
  std::size_t total = 0;
  std::string pipeline, scene;
  bool finished = false;     ///< else it is about to begin
  JobFigures figures{};      ///< if finished
  double seconds_left = -1;  ///< negative: not known yet
};

/// All are given the place of a job in the list.
struct JobHooks {
  std::function<RunOutcome(std::size_t)> run;
  /// Of a run that succeeded, now or earlier. What it throws is the job's failure.
  std::function<JobFigures(std::size_t)> judge;
  std::function<void(std::size_t, const std::string& failure)> fail;
  std::function<void(const BenchProgress&)> tell;
};

/// Runs the jobs that are not done and judges all that are. Returns whether it was interrupted:
/// then only what is done is judged. Throws Error if a folder cannot be written to.
XGM_API bool run_jobs(const std::vector<BenchJob>& jobs, const JobHooks& hooks);

/// The files that run_jobs itself writes to the folder of a job.
XGM_API std::vector<std::string> job_files(const std::string& folder);

struct FileIdentity;
/// Files as members of an identity.
XGM_API Json identity_json(const std::vector<FileIdentity>& files);

}  // namespace xgm
