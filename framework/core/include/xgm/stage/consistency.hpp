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
};

}  // namespace xgm
