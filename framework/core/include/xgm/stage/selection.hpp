// SPDX-License-Identifier: Apache-2.0
// Kind "selection": picks one disparity per pixel.
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Selection : public Stage {
 public:
  static constexpr std::string_view kKind = "selection";
  static constexpr std::string_view kMeaning = "picks one disparity per pixel";

  /// Whole disparities of `sums`, or out_of_range where no cell can match.
  virtual DisparityMap run(const AggregatedVolume& sums, const Context& context) const = 0;

  /// What every result is looked at for in a run: the map, and that disparities are whole ones of
  /// the pixels' ranges.
  static std::optional<Fault> fault_of(const DisparityMap& result, const AggregatedVolume& sums,
                                       const Context& context);
};

}  // namespace xgm
