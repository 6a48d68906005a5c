// SPDX-License-Identifier: Apache-2.0
// The input and the result of a matcher.
#pragma once

#include <optional>

#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/image.hpp"

namespace xgm {

/// A pair to match, and the range to search for its base view. `reverse_range` is the range of the
/// match view, for matchers that also compute the reverse map; without it, they use
/// range.reversed().
struct MatchRequest {
  ImagePair pair;
  DisparityRange range;
  std::optional<DisparityRange> reverse_range;
};

/// `forward` is the map of the base view, `reverse` the map of the match view. x_other = x - d
/// holds for both, so their disparities have opposite signs.
struct MatchResult {
  DisparityMap forward;
  std::optional<DisparityMap> reverse;
};

}  // namespace xgm
