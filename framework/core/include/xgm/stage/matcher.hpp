// SPDX-License-Identifier: Apache-2.0
// Kind "matcher": from an image pair to disparity maps. Matchers may hold matchers.
#pragma once

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Matcher : public Stage {
 public:
  static constexpr std::string_view kKind = "matcher";
  static constexpr std::string_view kMeaning =
      "finds the disparity maps of an image pair; matchers may hold matchers";

  virtual MatchResult run(const MatchRequest& request, const Context& context) const = 0;

  /// Used by slots: run(), or what an equal matcher has found already (see AskedOnce).
  static MatchResult answer(const Matcher& matcher, const MatchRequest& request,
                            const Context& context);

  /// What every result is looked at for in a run: both maps, and that masked pixels have no
  /// disparity.
  static std::optional<Fault> fault_of(const MatchResult& result, const MatchRequest& request,
                                       const Context& context);

  /// Whether pixels may have different ranges. If not, a pyramid refuses this matcher, and so does
  /// a run that is given range maps.
  virtual bool accepts_range_maps() const { return true; }

  /// How many times smaller than the images its coarsest level is; if above 1 it heeds the
  /// request's ScenePart.
  virtual int coarsest_scale() const { return 1; }

  /// Whether results hold the reverse map too. If so, left_right refuses this matcher: it would
  /// match four times.
  virtual bool gives_reverse_map() const { return false; }

  /// Whether maps come with a confidence, which stages after it may need.
  virtual bool gives_confidence() const { return false; }
};

}  // namespace xgm
