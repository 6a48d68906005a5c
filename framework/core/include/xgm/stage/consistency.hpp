// SPDX-License-Identifier: Apache-2.0
// Kind "consistency": do the maps of both views agree?
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Consistency : public Stage {
 public:
  static constexpr std::string_view kKind = "consistency";
  static constexpr std::string_view kMeaning = "compares the maps of both views";

  /// Invalidates disagreeing pixels of both maps, as occluded or mismatched. `result.reverse` is
  /// set.
  virtual MatchResult run(const MatchResult& result, const Context& context) const = 0;

  /// What every result is looked at for in a run: both maps: pixels are kept as they are or taken
  /// away.
  static std::optional<Fault> fault_of(const MatchResult& result, const MatchResult& maps,
                                       const Context& context);

  /// Hands the confidences of both maps on.
  static void complete(MatchResult& result, const MatchResult& maps) {
    result.forward.inherit_confidence(maps.forward);
    if (result.reverse && maps.reverse) result.reverse->inherit_confidence(*maps.reverse);
  }
};

}  // namespace xgm
