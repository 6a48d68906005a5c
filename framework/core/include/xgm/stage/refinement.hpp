// SPDX-License-Identifier: Apache-2.0
// Kind "refinement": sub-pixel shift of a whole disparity.
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Refinement : public Stage {
 public:
  static constexpr std::string_view kKind = "refinement";
  static constexpr std::string_view kMeaning = "moves a disparity by a fraction of a pixel";

  /// Moves each valid disparity of `map` (whole numbers, chosen from `sums`) by at most half a
  /// pixel.
  virtual DisparityMap run(const DisparityMap& map, const AggregatedVolume& sums,
                           const Context& context) const = 0;

  /// What every result is looked at for in a run: the map, and what it was made of.
  static std::optional<Fault> fault_of(const DisparityMap& result, const DisparityMap& map,
                                       const AggregatedVolume& sums, const Context& context);
};

}  // namespace xgm
