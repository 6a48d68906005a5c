// SPDX-License-Identifier: Apache-2.0
// What a run has found already and need not find again.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "xgm/base/export.hpp"
#include "xgm/base/json.hpp"
#include "xgm/data/match.hpp"

namespace xgm {

/// Belongs to one question: the same images, pipeline and range always have the same names. Called
/// from the thread that runs the pipeline.
class XGM_API KeptResults {
 public:
  virtual ~KeptResults();

  /// What the pipeline's matcher ("matcher"), or a level of it ("matcher.s4"), has found. None if
  /// it is not kept.
  virtual std::optional<MatchResult> find(const std::string& name) = 0;
  /// May throw Error.
  virtual void keep(const std::string& name, const MatchResult& result) = 0;

  /// For scenes that are matched in parts: a part of the finished map. Whoever keeps none takes
  /// nothing.
  virtual std::optional<DisparityMap> find_part(const std::string& name);
  virtual void keep_part(const std::string& name, const DisparityMap& part);
  /// For the run that makes the part; null if nothing is kept of it.
  virtual std::shared_ptr<KeptResults> of_part(const std::string& name);

  /// What a run has decided that another one might decide otherwise, such as the size of tiles.
  virtual Json decided(const std::string& what, const std::function<Json()>& decide);
};

/// Those of the run that the calling thread works for; null if it has none.
XGM_API KeptResults* kept_results();

/// While this lives, they are others for the calling thread, which outlive this; null: none.
class XGM_API KeptScope {
 public:
  explicit KeptScope(KeptResults* kept);
  ~KeptScope();
  KeptScope(const KeptScope&) = delete;
  KeptScope& operator=(const KeptScope&) = delete;

 private:
  struct Change;
  std::unique_ptr<Change> change_;
};

/// A part of the finished map, as `kept` has it; else as `make` makes it, which is handed what is
/// kept of the part (maybe null), and kept from then on. `kept` may be null.
XGM_API DisparityMap kept_part(KeptResults* kept, const std::string& name,
                               const std::function<DisparityMap(KeptResults* of_part)>& make);

}  // namespace xgm
