// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/keeping.hpp"

#include <filesystem>

#include "xgm/evaluation/run_folder.hpp"
#include "xgm/pipeline/result_cache.hpp"
#include "xgm/pipeline/unfinished_run.hpp"

namespace xgm {

std::string KeepRequest::option() const {
  if (!cache.empty()) return "--cache: ";
  return resume ? "--resume: " : "";
}

Keeping::Keeping() = default;
Keeping::~Keeping() = default;
Keeping::Keeping(Keeping&&) noexcept = default;
Keeping& Keeping::operator=(Keeping&&) noexcept = default;

Keeping::Keeping(const KeepRequest& request, const std::string& folder, Json question,
                 Json of_matcher, Observer* observer) {
  const auto tell = [observer](const std::string& text) {
    if (observer != nullptr) observer->log(LogLevel::warning, {}, text);
  };
  if (!request.cache.empty()) {
    folder_ = request.cache;
    cache_ = std::make_unique<ResultCache>(folder_, request.cache_bytes, of_matcher, tell);
    return;
  }
  for (const auto& [option, value] : request.asked) question[option] = value;
  folder_ = (std::filesystem::path(folder) / kUnfinishedFolder).string();
  unfinished_ = std::make_unique<UnfinishedRun>(
      folder_, std::move(question), UnfinishedRun::Options{.resume = request.resume, .tell = tell});
}

KeptResults* Keeping::results() const {
  if (cache_) return cache_.get();
  return unfinished_.get();
}

std::vector<std::string> Keeping::reused() const {
  if (cache_) return cache_->reused();
  return unfinished_ ? unfinished_->reused() : std::vector<std::string>();
}

void Keeping::end() {
  if (unfinished_) unfinished_->remove();
}

}  // namespace xgm
