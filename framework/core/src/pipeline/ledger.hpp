// SPDX-License-Identifier: Apache-2.0
// The books of a plan: what is held now, and the most that was held while each stage ran.
#pragma once

#include <optional>
#include <vector>

#include "xgm/pipeline/plan.hpp"

namespace xgm {

struct PlanLedger {
  std::optional<Narrowing> narrowing{};

  double others = 0, volumes = 0;  ///< held now
  /// The most since free memory went back to the system. What is freed waits to be used again, in
  /// the heap or as BufferReuse says: it counts as long.
  double max_others = 0, max_volumes = 0;
  double holes = 0;  ///< of the heap: free, but no longer used again
  double peak_bytes = 0;
  std::size_t peak_row = 0;            ///< in which stage that was reached
  std::vector<PlannedStage> stages{};  ///< in the order in which they begin
  std::vector<std::size_t> open{};     ///< rows of the stages that run now, outermost first

  void add(double more_others, double more_volumes);
};

}  // namespace xgm
