// SPDX-License-Identifier: Apache-2.0
// The input and the result of a matcher.
#pragma once

#include <optional>

#include "xgm/data/disparity_map.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/data/image.hpp"

namespace xgm {

/// `forward` is the map of the base view, `reverse` the map of the match view. x_other = x - d
/// holds for both, so their disparities have opposite signs.
struct MatchResult {
  DisparityMap forward;
  std::optional<DisparityMap> reverse;
};

/// The place of a request in the question about a whole scene, whose images are matched in parts.
struct ScenePart {
  /// How many times smaller than the scene's the images are, a power of two. If above 1, pyramids
  /// do only the levels from here on up, and nothing is done after matching.
  int scale = 1;
  /// Maps of the same part, `coarse_scale` times smaller (each side rounded up): pyramids begin
  /// with the level below.
  std::optional<MatchResult> coarse{};
  int coarse_scale = 1;
};

/// A pair to match, and the range to search for its base view. `reverse_range` is the range of the
/// match view, for matchers that also compute the reverse map; without it, they use
/// range.reversed().
struct MatchRequest {
  ImagePair pair;
  DisparityRange range;
  std::optional<DisparityRange> reverse_range;
  /// Set if the pair, which is prepared already, is a part of a scene.
  std::optional<ScenePart> part{};
};

}  // namespace xgm
