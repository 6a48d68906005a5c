// SPDX-License-Identifier: Apache-2.0
// Kind "matcher": from an image pair to disparity maps. Matchers may hold matchers.
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/planner.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Matcher : public Stage {
 public:
  static constexpr std::string_view kKind = "matcher";

  virtual MatchResult run(const MatchRequest& request, const Context& context) const = 0;

  /// Whether pixels may have different ranges. If not, a pyramid refuses this matcher, and so does
  /// a run that is given range maps.
  virtual bool accepts_range_maps() const { return true; }

  /// Whether results hold the reverse map too. If so, left_right refuses this matcher: it would
  /// match four times.
  virtual bool gives_reverse_map() const { return false; }

  /// What run() takes, for plans; the default: the maps, costs and sums.
  virtual Needs needs(const Workload& load) const;

  /// A matcher that holds stages plans them in the order in which run() calls them; see Planner.
  /// The result holds the maps.
  virtual Planner::Hold plan(const Workload& load, const Planner& planner) const;
};

}  // namespace xgm
