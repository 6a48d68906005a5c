// SPDX-License-Identifier: Apache-2.0
#include "record/keeping.hpp"

#include <filesystem>

#include "xgm/evaluation/run_folder.hpp"
#include "xgm/pipeline/question.hpp"

namespace xgm {
namespace {

/// Results of stages that are not run would be missing.
bool shows_stages(const RecordRequest& request) {
  return request.report || !request.dump.empty() || !request.explained.empty();
}

/// Images in memory have no hashes by which they are known again.
bool is_in_files(const SceneRequest& scene) {
  return std::holds_alternative<SceneFiles>(scene.scene);
}

std::string option_of(const KeepRequest& keep) {
  if (!keep.cache.empty()) return "--cache: ";
  return keep.resume ? "--resume: " : "";
}

}  // namespace

void Keeping::check(const RecordRequest& request, const SceneRequest& scene) {
  const std::string option = request.keep ? option_of(*request.keep) : "";
  if (option.empty()) return;
  if (shows_stages(request)) {
    throw UsageError(option +
                     "stages whose results are kept are not run again; leave it out, or leave out "
                     "--report, --dump and --explain");
  }
  if (!is_in_files(scene)) {
    throw UsageError(option + "needs images in files: give a SCENE_DIR, or --left and --right");
  }
}

Keeping::Keeping(const Pipeline& pipeline, const SceneRequest& scene, const SceneInputs& inputs,
                 const RecordRequest& request, Observer* observer) {
  if (!request.keep || shows_stages(request) || !is_in_files(scene)) return;
  const KeepRequest& keep = *request.keep;
  const auto tell = [observer](const std::string& text) {
    if (observer != nullptr) observer->log(LogLevel::warning, {}, text);
  };
  Json question = question_of(pipeline, scene, inputs, keep.plugin_files);
  if (!keep.cache.empty()) {
    folder_ = keep.cache;
    cache_ = std::make_unique<ResultCache>(folder_, keep.cache_bytes,
                                           question_of_matcher(std::move(question)), tell);
    return;
  }
  for (const auto& [option, value] : keep.asked) question[option] = value;
  folder_ = (std::filesystem::path(request.folder) / kUnfinishedFolder).string();
  unfinished_ = std::make_unique<UnfinishedRun>(
      folder_, std::move(question), UnfinishedRun::Options{.resume = keep.resume, .tell = tell});
}

KeptResults* Keeping::results() const {
  if (cache_) return cache_.get();
  return unfinished_.get();
}

void Keeping::describe(RunRecord& record) const {
  if (results() == nullptr) return;
  record.reused = cache_ ? cache_->reused() : unfinished_->reused();
  record.reused_from = folder_;
}

void Keeping::end() {
  if (unfinished_) unfinished_->remove();
}

}  // namespace xgm
