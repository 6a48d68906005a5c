// SPDX-License-Identifier: Apache-2.0
// Kind "filter": from a disparity map to a better one.
#pragma once

#include <algorithm>

#include "xgm/stage/context.hpp"
#include "xgm/stage/stage.hpp"

namespace xgm {

class XGM_API Filter : public Stage {
 public:
  static constexpr std::string_view kKind = "filter";
  static constexpr std::string_view kMeaning = "makes a better disparity map of a disparity map";

  /// `pair.base` is the view that `map` belongs to. Returns a map of the same size.
  virtual DisparityMap run(const DisparityMap& map, const ImagePair& pair,
                           const Context& context) const = 0;

  /// Whether maps must have a confidence. What holds the filter refuses it if they have none.
  virtual bool needs_confidence() const { return false; }

  /// What every result is looked at for in a run: the map, and what the run searches: matched
  /// disparities lie in it.
  static std::optional<Fault> fault_of(const DisparityMap& result, const DisparityMap& map,
                                       const ImagePair& pair, const Context& context);

  /// Hands the confidence of the map on.
  static void complete(DisparityMap& result, const DisparityMap& map, const ImagePair&) {
    result.inherit_confidence(map);
  }
};

/// Whether one of these slots holds a filter that needs a confidence.
template <class Slots>
bool any_needs_confidence(const Slots& filters) {
  return std::ranges::any_of(filters, [](const auto& slot) { return slot->needs_confidence(); });
}

}  // namespace xgm
