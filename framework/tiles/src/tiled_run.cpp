// SPDX-License-Identifier: Apache-2.0
#include "xgm/tiles/tiled_run.hpp"

#include "choose_tiles.hpp"
#include "tiled_match.hpp"
#include "tiles_as_one.hpp"
#include "xgm/base/aligned_buffer.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/text.hpp"
#include "xgm/stage/kept_results.hpp"

namespace xgm::tiles {
namespace {

/// Share of the time that the levels above the tiles take, and what is done before them.
constexpr double kBeforeTiles = 0.1;

/// What the run keeps, by names that tell which tiles a result belongs to.
class KeptTiles {
 public:
  KeptTiles(KeptResults* kept, const TileOptions& tiles)
      : kept_(kept),
        of_tiles_(" of " + size_text(tiles.size) + " with a halo of " + std::to_string(tiles.halo) +
                  ", " + short_number(tiles.coarse_pixels) + " coarse pixels") {}

  void match_coarse(TiledMatch& match, const RunOptions& options) const {
    std::optional<MatchResult> found;
    if (kept_ != nullptr && match.has_coarse()) found = kept_->find(kCoarse + of_tiles_);
    if (found) {
      match.use(std::move(*found));
      return;
    }
    match.match_coarse(options);
    if (kept_ != nullptr && match.has_coarse()) kept_->keep(kCoarse + of_tiles_, match.coarse());
  }

  DisparityMap match_part(const TiledMatch& match, const std::string& name, const cv::Rect& part,
                          RunOptions options) const {
    return kept_part(kept_, name + of_tiles_, [&](KeptResults* of_part) {
      options.kept = of_part;
      return match.match(part, options);
    });
  }

 private:
  KeptResults* kept_;
  std::string of_tiles_;
};

}  // namespace

void run_in_tiles(const Pipeline& pipeline, const TiledRequest& request, const TileOptions& tiles,
                  const TakePart& take, const RunOptions& options) {
  TilesAsOne observer(options.observer);
  RunOptions watched = options;
  watched.observer = &observer;
  watched.kept = nullptr;  // which are of the whole
  const KeptTiles kept(options.kept, tiles);
  TiledMatch match(pipeline, request, tiles);
  observer.next(0, kBeforeTiles / 2, false);
  match.prepare(watched);
  observer.next(kBeforeTiles / 2, kBeforeTiles, false);
  kept.match_coarse(match, watched);
  trim_heap();
  const std::vector<cv::Rect> all = match.parts();
  const std::vector<std::string> names = names_of(all);
  std::optional<BufferReuse> reuse;
  if (tiles.keeps_memory) reuse.emplace();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double each = (1 - kBeforeTiles) / static_cast<double>(all.size());
    const double begin = kBeforeTiles + each * static_cast<double>(i);
    observer.next(begin, begin + each, true);
    take(all[i], kept.match_part(match, names[i], all[i], watched));
    if (!reuse) trim_heap();  // what filters leave in pieces adds up from tile to tile
  }
  observer.finish();
}

}  // namespace xgm::tiles
