// SPDX-License-Identifier: Apache-2.0
// Sums up what each stage of a run takes for itself.
// Exported for the tests only: the header is not installed.
#pragma once

#include <string>
#include <vector>

#include "xgm/stage/context.hpp"

namespace xgm::speed {

/// "aggregation sgm": kind and plugin.
XGM_API std::string stage_name(const StagePlace& place);

/// Stages of one name are one, whatever the level and view. The time of a stage does not hold that
/// of the stages inside.
class XGM_API StageClock final : public Observer {
 public:
  struct Total {
    std::string stage;
    double seconds = 0;
  };

  void stage_begin(const StagePlace& place) override;
  void stage_end(const StagePlace& place, const StageStatistics& statistics,
                 const Artifact& result) override;

  /// In the order in which they began for the first time.
  const std::vector<Total>& totals() const { return totals_; }

 private:
  struct Open {
    std::size_t total;
    double inside = 0;  ///< seconds of the stages in this one
  };
  std::vector<Total> totals_;
  std::vector<Open> open_;
};

}  // namespace xgm::speed
