// SPDX-License-Identifier: Apache-2.0
// A pair that is matched in tiles, step by step: looks at the whole of it, the coarse levels, then
// any tile by itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coarse_maps.hpp"
#include "xgm/tiles/tiled_run.hpp"
#include "xgm/tiles/tiling.hpp"

namespace xgm::tiles {

/// Names of the steps before the tiles.
inline constexpr const char* kFit = "fit";
inline constexpr const char* kCoarse = "coarse";

/// Of the tiles that match them: "tile_ROW_COLUMN" from 1 on.
std::vector<std::string> names_of(const std::vector<cv::Rect>& parts);

class TiledMatch {
 public:
  /// The pipeline outlives it.
  TiledMatch(const Pipeline& pipeline, TiledRequest request, const TileOptions& tiles)
      : pipeline_(pipeline), request_(std::move(request)), tiles_(tiles) {}

  /// Fits what is fitted to the whole images. Comes first.
  void prepare(const RunOptions& options);
  /// The same in two steps, of which each process but one needs the second alone.
  std::string find_on_whole(const RunOptions& options) const;
  void prepare_with(const std::string& found, const RunOptions& options);

  /// Whether there are coarse levels, which have to be matched or given before any tile.
  bool has_coarse() const;
  void match_coarse(const RunOptions& options);
  void use(MatchResult coarse);
  /// Of them, the rows that the tiles need which are matched.
  void use(CoarseMaps coarse) { coarse_ = std::move(coarse); }
  const MatchResult& coarse() const { return coarse_->maps; }

  /// The tiles' parts of the map, row by row.
  std::vector<cv::Rect> parts() const;
  DisparityMap match(const cv::Rect& part, const RunOptions& options) const;

 private:
  MatchRequest request_of(const Surroundings& around, Interval hull) const;
  DisparityRange reverse_range(const Surroundings& around, Interval hull) const;

  const Pipeline& pipeline_;
  TiledRequest request_;
  TileOptions tiles_;
  std::optional<CoarseMaps> coarse_;
};

}  // namespace xgm::tiles
