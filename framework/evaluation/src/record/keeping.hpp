// SPDX-License-Identifier: Apache-2.0
// What a recorded run keeps of its results, and where.
#pragma once

#include <memory>

#include "xgm/evaluation/recorded_run.hpp"
#include "xgm/pipeline/result_cache.hpp"
#include "xgm/pipeline/unfinished_run.hpp"

namespace xgm {

class Keeping {
 public:
  /// Throws UsageError if results are to be kept of a run that cannot go on from them. Opens no
  /// image.
  static void check(const RecordRequest& request, const SceneRequest& scene);

  /// Keeps nothing.
  Keeping() = default;
  /// `inputs` were read from `scene`. Throws UsageError.
  Keeping(const Pipeline& pipeline, const SceneRequest& scene, const SceneInputs& inputs,
          const RecordRequest& request, Observer* observer);

  /// Null if nothing is kept.
  KeptResults* results() const;
  void describe(RunRecord& record) const;
  /// The run has ended well.
  void end();

 private:
  std::unique_ptr<UnfinishedRun> unfinished_;
  std::unique_ptr<ResultCache> cache_;
  std::string folder_;
};

}  // namespace xgm
