// SPDX-License-Identifier: Apache-2.0
// Matches a pair in tiles: memory is that of one tile, whatever the size of the images.
#pragma once

#include <memory>

#include "xgm/base/export.hpp"
#include "xgm/data/pair_windows.hpp"
#include "xgm/pipeline/scene_run.hpp"

namespace xgm::tiles {

struct TileOptions {
  cv::Size size{2000, 2000};  ///< of a tile's part of the map, at most, px
  /// Pixels around a tile that are matched, too, and thrown away. Sums of path costs forget what is
  /// this far away nearly always, filters reach less far.
  int halo = 128;
  /// Coarse levels of pyramids are matched as a whole, so that tiles agree about the scene: as many
  /// of them as have at most so many pixels, and the coarsest in any case.
  double coarse_pixels = 8e6;
  /// Whether memory is kept from tile to tile: faster, as the system clears it but once, and that
  /// of volumes is held while maps are worked on. No result depends on it.
  bool keeps_memory = false;
};

/// What is to be matched. The range is uniform, or of one interval per pixel.
struct TiledRequest {
  std::shared_ptr<const PairWindows> pair;
  DisparityRange range;
};

/// `take` is given the parts tile by tile. A pyramid's levels above the tiles are matched as one
/// image; each tile then goes on from its part of their maps. Results are the same for any number
/// of threads. The observer is told of the stages of each tile. Throws what Pipeline::run() throws.
XGM_API void run_in_tiles(const Pipeline& pipeline, const TiledRequest& request,
                          const TileOptions& tiles, const TakePart& take,
                          const RunOptions& options = {});

}  // namespace xgm::tiles
