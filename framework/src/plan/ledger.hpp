// SPDX-License-Identifier: Apache-2.0
// The books of a plan: what is held now, and the most that was held while each stage ran.
#pragma once

#include <optional>
#include <vector>

#include "xgm/plan.hpp"

namespace xgm {

struct PlanLedger {
  std::optional<Narrowing> narrowing{};

  double others = 0;   ///< held now
  double volumes = 0;  ///< held now
  /// Freed volumes wait to be used again, see CellReuse: their memory counts as long.
  double most_volumes = 0;
  std::vector<PlannedStage> stages{};  ///< in the order in which they begin
  std::vector<std::size_t> open{};     ///< rows of the stages that run now, outermost first

  void add(double more_others, double more_volumes);
};

}  // namespace xgm
