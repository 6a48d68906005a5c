// SPDX-License-Identifier: Apache-2.0
// Kind "aggregation": from matching costs to sums that know the neighbourhood (the paper's Eq. 3 to
// 6).
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/penalty.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Aggregation : public Stage {
 public:
  static constexpr std::string_view kKind = "aggregation";
  static constexpr std::string_view kMeaning = "sums the costs along paths through the image";

  /// S(p, d) for every cell of the costs' shape; kNoMatch exactly where the cost is kNoMatch.
  virtual AggregatedVolume run(const CostVolume& costs, const PenaltyField& penalties,
                               const Context& context) const = 0;

  /// What every result is looked at for in a run: shape and fraction bits; not its cells, which are
  /// too many.
  static std::optional<Fault> fault_of(const AggregatedVolume& result, const CostVolume& costs,
                                       const PenaltyField& penalties, const Context& context);

  /// Whether pixels may have different ranges. If not, a pyramid refuses this aggregation.
  virtual bool accepts_ragged_volumes() const { return true; }
};

}  // namespace xgm
