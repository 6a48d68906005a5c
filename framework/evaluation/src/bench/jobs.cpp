// SPDX-License-Identifier: Apache-2.0
// Runs what is not done, and judges all that is.
#include <algorithm>
#include <chrono>
#include <filesystem>

#include "xgm/base/error.hpp"
#include "xgm/evaluation/bench_jobs.hpp"
#include "xgm/io/file.hpp"

namespace xgm {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "cell.json";
constexpr const char* kRecord = "run.json";

std::string in(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

Json json(const FileIdentity& identity) {
  return {{"bytes", identity.bytes}, {"fnv1a64", identity.fnv1a64}};
}

/// What a bench reads of a run.
Json results(const BenchJob& job) {
  Json results;
  for (const std::string& name : {std::string(kRecord), job.result}) {
    results[name] = json(identify_file(in(job.folder, name)));
  }
  return results;
}

/// Whether mark_done was called for this job, and its files are as they were then.
bool is_done(const BenchJob& job) {
  try {
    const Json mark = Json::parse(read_file(in(job.folder, kMark)));
    return mark.at("identity").dump() == job.identity &&
           mark.at("results").dump() == results(job).dump();
  } catch (const std::exception&) {
    return false;  // missing, or cut short: run it again
  }
}

/// Before a run: what is there tells of nothing any more.
void begin(const BenchJob& job) {
  std::error_code failure;
  fs::create_directories(job.folder, failure);
  if (failure) throw Error(job.folder + ": cannot be made: " + failure.message());
  for (const char* name : {kMark, kRecord}) fs::remove(in(job.folder, name), failure);
}

void mark_done(const BenchJob& job) {
  const Json mark{{"identity", Json::parse(job.identity)}, {"results", results(job)}};
  write_file(in(job.folder, kMark), mark.dump(2) + "\n");
}

class Jobs {
 public:
  Jobs(const std::vector<BenchJob>& jobs, const JobHooks& hooks) : jobs_(jobs), hooks_(hooks) {}

  bool run() {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      if (!is_done(jobs_[i])) missing_.push_back(i);
    }
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const bool missing = std::binary_search(missing_.begin(), missing_.end(), i);
      if (missing && !interrupted_) run(i);
      if (!missing) judge(i);
    }
    return interrupted_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void run(std::size_t i) {
    tell(i, nullptr);
    const auto start = Clock::now();
    begin(jobs_[i]);
    const RunOutcome outcome = hooks_.run(i);
    if (outcome.interrupted) {
      interrupted_ = true;
      return;
    }
    const JobFigures figures = outcome.failure.empty() ? judge(i, [&] { mark_done(jobs_[i]); })
                                                       : failed(i, outcome.failure);
    seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
    ++runs_;
    tell(i, &figures);
  }

  JobFigures judge(
      std::size_t i, const std::function<void()>& before = [] {}) {
    try {
      before();
      return hooks_.judge(i);
    } catch (const std::exception& error) {
      return failed(i, error.what());
    }
  }

  JobFigures failed(std::size_t i, const std::string& why) {
    hooks_.fail(i, why);
    return {.failure = why};
  }

  void tell(std::size_t i, const JobFigures* figures) const {
    const auto left = static_cast<double>(missing_.size() - runs_);
    hooks_.tell({.number = i + 1,
                 .total = jobs_.size(),
                 .pipeline = jobs_[i].pipeline,
                 .scene = jobs_[i].scene,
                 .finished = figures != nullptr,
                 .figures = figures != nullptr ? *figures : JobFigures{},
                 .seconds_left = runs_ > 0 ? left * seconds_ / static_cast<double>(runs_) : -1});
  }

  const std::vector<BenchJob>& jobs_;
  const JobHooks& hooks_;
  std::vector<std::size_t> missing_;  // ascending
  bool interrupted_ = false;
  std::size_t runs_ = 0;  // of the missing ones
  double seconds_ = 0;    // that they took
};

}  // namespace

bool run_jobs(const std::vector<BenchJob>& jobs, const JobHooks& hooks) {
  return Jobs(jobs, hooks).run();
}

std::vector<std::string> job_files(const std::string& folder) {
  return {in(folder, kRecord), in(folder, kMark), in(folder, kCellLog)};
}

Json identity_json(const std::vector<FileIdentity>& files) {
  Json list = Json::array();
  for (const FileIdentity& file : files) list.push_back(json(file));
  return list;
}

const char* state_text(CellState state) {
  switch (state) {
    case CellState::done:
      return "done";
    case CellState::failed:
      return "failed";
    case CellState::not_run:
      return "not run";
  }
  return "";
}

}  // namespace xgm
