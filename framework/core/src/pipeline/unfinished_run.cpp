// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/unfinished_run.hpp"

#include <filesystem>

#include "pipeline/result_folder.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/pipeline/question.hpp"

namespace xgm {
namespace {

namespace fs = std::filesystem;

constexpr const char* kQuestionFile = "question.json";

std::string question_file(const std::string& folder) {
  return (fs::path(folder) / kQuestionFile).string();
}

/// Only what a run has made: a folder that says so, or one in which it had just begun.
void remove_run(const std::string& folder) {
  std::error_code unusable;
  if (!fs::exists(folder, unusable)) return;
  bool is_run = fs::exists(question_file(folder), unusable);
  if (!is_run && fs::is_directory(folder, unusable)) {
    is_run = true;
    for (const auto& entry : fs::directory_iterator(folder, unusable)) {
      is_run = is_run && entry.path().filename().string().starts_with(".xgm.");
    }
  }
  if (!is_run) {
    throw UsageError(folder + ": is not what a run has left; move it away");
  }
  // What says that it is a run's goes last: a removal that is cut short leaves one, too.
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder, unusable)) {
    if (entry.path().filename() != kQuestionFile) fs::remove_all(entry.path(), failure);
    if (failure) break;
  }
  if (!failure) fs::remove_all(folder, failure);
  if (failure) throw Error(folder + ": cannot be removed: " + failure.message());
}

}  // namespace

UnfinishedRun::UnfinishedRun(const std::string& folder, Json question, Options options)
    : question_(std::move(question)),
      options_(std::move(options)),
      results_(std::make_unique<ResultFolder>(folder, hash_text(question_.dump()), options_.tell)),
      begin_(std::chrono::steady_clock::now()) {
  std::error_code unusable;
  if (options_.resume && fs::exists(question_file(folder), unusable)) take_up();
  if (!is_there_) remove_run(folder);
}

UnfinishedRun::~UnfinishedRun() = default;

void UnfinishedRun::take_up() {
  const std::string file = question_file(results_->path());
  Json earlier;
  try {
    const Json stored = Json::parse(read_file(file));
    earlier = stored.at("question");
    decisions_ = stored.at("decisions");
  } catch (const Error&) {
    options_.tell(file + ": is damaged; the run begins anew");
    return;
  }
  const std::string differs = difference(earlier, question_);
  if (!differs.empty()) {
    throw UsageError("--resume: the run that has left " + results_->path() +
                     " was another one: " + differs + " differ; ask for the same again, or leave " +
                     "out --resume to begin anew");
  }
  is_there_ = true;
}

std::optional<MatchResult> UnfinishedRun::find(const std::string& name) {
  return is_there_ ? results_->find(name) : std::nullopt;
}

void UnfinishedRun::keep(const std::string& name, const MatchResult& result) {
  if (!options_.resume && !is_cheap(result)) return;
  if (!is_there_) {
    make_output_folder(results_->path());
    write_question();
    is_there_ = true;
  }
  results_->write(name, result);
}

bool UnfinishedRun::is_cheap(const MatchResult& result) const {
  constexpr double kBytesPerSecond = 150e6;  // written, hashed and on a disk that is no fast one
  const std::chrono::duration<double> run = std::chrono::steady_clock::now() - begin_;
  const std::size_t bytes = result.forward.bytes() + (result.reverse ? result.reverse->bytes() : 0);
  return run.count() >= options_.after_seconds &&
         static_cast<double>(bytes) / kBytesPerSecond <= options_.share * run.count();
}

std::optional<DisparityMap> UnfinishedRun::find_part(const std::string& name) {
  std::optional<MatchResult> found = find(name);
  return found ? std::optional(std::move(found->forward)) : std::nullopt;
}

void UnfinishedRun::keep_part(const std::string& name, const DisparityMap& part) {
  keep(name, {part, std::nullopt});
}

Json UnfinishedRun::decided(const std::string& what, const std::function<Json()>& decide) {
  if (const Json* const earlier = decisions_.find(what)) return *earlier;
  decisions_[what] = decide();
  if (is_there_) write_question();
  return decisions_.at(what);
}

void UnfinishedRun::write_question() const {
  const std::string file = question_file(results_->path());
  write_file(file, Json{{"question", question_}, {"decisions", decisions_}}.dump(2) + "\n");
  sync_file(file);
}

const std::vector<std::string>& UnfinishedRun::reused() const { return results_->found(); }

void UnfinishedRun::remove() {
  if (is_there_) remove_run(results_->path());
  is_there_ = false;
}

}  // namespace xgm
