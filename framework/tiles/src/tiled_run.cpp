// SPDX-License-Identifier: Apache-2.0
#include "xgm/tiles/tiled_run.hpp"

#include "tiled_match.hpp"
#include "tiles_as_one.hpp"
#include "xgm/base/memory.hpp"

namespace xgm::tiles {
namespace {

/// Share of the time that the levels above the tiles take, and what is done before them.
constexpr double kBeforeTiles = 0.1;

}  // namespace

void run_in_tiles(const Pipeline& pipeline, const TiledRequest& request, const TileOptions& tiles,
                  const TakePart& take, const RunOptions& options) {
  TilesAsOne observer(options.observer);
  RunOptions watched = options;
  watched.observer = &observer;
  TiledMatch match(pipeline, request, tiles);
  observer.next(0, kBeforeTiles / 2, false);
  match.prepare(watched);
  observer.next(kBeforeTiles / 2, kBeforeTiles, false);
  match.match_coarse(watched);
  trim_heap();
  const std::vector<cv::Rect> all = match.parts();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double each = (1 - kBeforeTiles) / static_cast<double>(all.size());
    const double begin = kBeforeTiles + each * static_cast<double>(i);
    observer.next(begin, begin + each, true);
    take(all[i], match.match(all[i], watched));
  }
  observer.finish();
}

}  // namespace xgm::tiles
