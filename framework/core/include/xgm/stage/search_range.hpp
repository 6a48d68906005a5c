// SPDX-License-Identifier: Apache-2.0
// Kind "search_range": what the next finer level of a pyramid has to search, given the coarser map.
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/needs.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API SearchRange : public Stage {
 public:
  static constexpr std::string_view kKind = "search_range";

  /// `coarse` is the checked map of the coarser level, in its own pixels. `limits` is what the
  /// finer level may search at all; its size is that of the finer level, pixel (x, y) lying in
  /// coarse pixel (x / 2, y / 2). Returns the range of the finer level (the pyramid keeps it within
  /// `limits`).
  virtual DisparityRange run(const DisparityMap& coarse, const DisparityRange& limits,
                             const Context& context) const = 0;

  /// What run() takes, for plans; the default: a range of the finer level and as much beside it.
  /// `load` is that of the finer level.
  virtual Needs needs(const Workload& load) const;
  /// How far this narrows the search of a scene of which nothing is known; the default is typical
  /// of Middlebury's.
  virtual Narrowing narrowing() const { return {}; }
};

}  // namespace xgm
