// SPDX-License-Identifier: Apache-2.0
// What several matchers inside a stage would find alike is found once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "xgm/base/export.hpp"
#include "xgm/stage/matcher.hpp"
#include "xgm/stage/slot.hpp"

namespace xgm {

/// For one call of a stage that runs several matchers, its members, on one request. Equal matchers
/// are one object (the binder sees to that). Where one is inside several members, what it finds for
/// the request, or for that of the other view, is kept for the later ones, until the last of them
/// has been given it. Nothing else is kept: levels of pyramids are seldom asked the same twice.
class XGM_API AskedOnce {
 public:
  /// Each of `members` is going to be asked once, in their order. `request` outlives this.
  AskedOnce(const MatchRequest& request, const SlotList<Matcher>& members);
  AskedOnce(const AskedOnce&) = delete;
  AskedOnce& operator=(const AskedOnce&) = delete;

  /// Runs the next member on the request.
  MatchResult ask(const Slot<Matcher>& member, const Context& context);

  /// Of a matcher inside the member that runs: what it finds, or has found. The maps are the
  /// caller's own.
  MatchResult answer(const Matcher& matcher, const MatchRequest& request, const Context& context);

 private:
  struct Answer {
    std::string path;  ///< of the call that has found it
    MatchResult result;
  };

  /// Whether it is asked for the other view; none if it is asked something else.
  std::optional<bool> other_view_asked(const Matcher& matcher, const MatchRequest& request) const;
  void forget(const Slot<Matcher>& member);

  const MatchRequest& request_;
  std::optional<MatchRequest> of_other_view_;
  std::map<const Stage*, int>
      uses_;  ///< members that hold it and are not done; at first two or more
  std::map<std::pair<const Stage*, bool>, Answer> kept_;  ///< by matcher and view
};

}  // namespace xgm
