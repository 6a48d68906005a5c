// SPDX-License-Identifier: Apache-2.0
// The levels of a pyramid that are matched as a whole.
#pragma once

#include <optional>

#include "xgm/tiles/tiled_run.hpp"

namespace xgm::tiles {

struct CoarseMaps {
  int scale = 1;  ///< how many times smaller than the images the maps are
  MatchResult maps;
  int first_row = 0;  ///< of theirs: they may be a part of the rows
};

/// That of the finest level that is matched as a whole: with no more pixels than are allowed, or
/// the coarsest. 1 without a pyramid.
int coarse_scale(const Pipeline& pipeline, cv::Size image, const TileOptions& tiles);

/// None without a pyramid.
std::optional<CoarseMaps> match_coarse(const Pipeline& pipeline, const TiledRequest& request,
                                       const TileOptions& tiles, const RunOptions& options);

/// The part of the maps that covers a window whose sides are multiples of the scale, or the
/// image's.
MatchResult part_of(const CoarseMaps& coarse, const cv::Rect& window);

/// The rows of the maps that a tile with this part of the map needs.
cv::Range rows_needed(const cv::Rect& part, const TileOptions& tiles, cv::Size image, int scale);

/// Hull of what the base pixels of `place` can take by the coarse maps; `limits` if these know
/// nothing there.
Interval likely(const CoarseMaps& coarse, const cv::Rect& place, Interval limits);

}  // namespace xgm::tiles
