// SPDX-License-Identifier: Apache-2.0
// What a recorded run keeps of its results, and where, so that another run need not find them
// again.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/base/json.hpp"
#include "xgm/stage/observer.hpp"

namespace xgm {

class KeptResults;
class ResultCache;
class UnfinishedRun;

/// How results are kept.
struct KeepRequest {
  /// Go on from what a run of the same question has left in the folder (UnfinishedRun).
  bool resume = false;
  /// A folder for results of matchers of any run (ResultCache). Runs with one leave nothing in
  /// their own folder: what they have done is in the cache.
  std::string cache{};
  std::uint64_t cache_bytes = 10'000'000'000;
  std::vector<std::string> plugin_files{};  ///< that the pipeline may have stages of
  /// Options beside pipeline and scene that have to be the same to go on, and their values.
  std::vector<std::pair<std::string, std::string>> asked{};

  /// "--cache: ", for errors; empty if the run merely keeps what costs it little.
  XGM_API std::string option() const;
};

class XGM_API Keeping {
 public:
  /// Keeps nothing.
  Keeping();
  /// Of a run that writes to `folder`. `question` decides of all that it finds (question_of()),
  /// `of_matcher` of what its matchers find. Throws UsageError.
  Keeping(const KeepRequest& request, const std::string& folder, Json question, Json of_matcher,
          Observer* observer);
  ~Keeping();
  Keeping(Keeping&& other) noexcept;
  Keeping& operator=(Keeping&& other) noexcept;

  /// Null if nothing is kept.
  KeptResults* results() const;
  /// Where results are kept, and the names of those that were found there.
  const std::string& folder() const { return folder_; }
  std::vector<std::string> reused() const;
  /// The run has ended well.
  void end();

 private:
  std::unique_ptr<UnfinishedRun> unfinished_;
  std::unique_ptr<ResultCache> cache_;
  std::string folder_;
};

}  // namespace xgm
