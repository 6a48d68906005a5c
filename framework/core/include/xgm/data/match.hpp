// SPDX-License-Identifier: Apache-2.0
// What a matcher is asked, and what it answers.
#pragma once

#include <optional>

#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/image.hpp"

namespace xgm {

/// Match `pair` within `range` (of the base view). `reverse_range` is the range of the match view
/// for matchers that also compute the reverse map; without it they use range.reversed().
struct MatchRequest {
  ImagePair pair;
  DisparityRange range;
  std::optional<DisparityRange> reverse_range;
};

/// `forward` is the map of the base view, `reverse` that of the match view (its disparities are the
/// negatives: the formula x_other = x - d holds for both).
struct MatchResult {
  DisparityMap forward;
  std::optional<DisparityMap> reverse;
};

}  // namespace xgm
