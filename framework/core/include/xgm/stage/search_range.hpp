// SPDX-License-Identifier: Apache-2.0
// Kind "search_range": what the next finer level of a pyramid has to search, given the coarser map.
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API SearchRange : public Stage {
 public:
  static constexpr std::string_view kKind = "search_range";
  static constexpr std::string_view kMeaning =
      "narrows what the next finer level of a pyramid searches";

  /// `coarse` is the checked map of the coarser level, in its own pixels. `limits` is what the
  /// finer level may search at all; its size is that of the finer level, pixel (x, y) lying in
  /// coarse pixel (x / 2, y / 2). Returns the range of the finer level (the pyramid keeps it within
  /// `limits`).
  virtual DisparityRange run(const DisparityMap& coarse, const DisparityRange& limits,
                             const Context& context) const = 0;

  /// What every result is looked at for in a run: size, and that no interval is inverted, nor empty
  /// where the limits are not.
  static std::optional<Fault> fault_of(const DisparityRange& result, const DisparityMap& coarse,
                                       const DisparityRange& limits, const Context& context);
};

}  // namespace xgm
