// SPDX-License-Identifier: Apache-2.0
#include "xgm/tiles/in_tiles.hpp"

#include <algorithm>

#include "xgm/base/error.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/base/text.hpp"
#include "xgm/pipeline/plan.hpp"

namespace xgm::tiles {
namespace {

constexpr int kSmallestTile = 256;  // below, most of what is matched is halo

/// Bytes of what is kept of the whole scene: the images, the map, and pictures of it.
double held(const MatchRequest& request, const SceneInputs& inputs) {
  const Workload load = workload_of(request, 1);
  const double map_bytes = 5;
  return 2 * load.image_bytes() + map_bytes * load.pixels() + inputs.besides.after;
}

void paste(const DisparityMap& part, const cv::Rect& place, DisparityMap& whole) {
  part.disparity.copyTo(whole.disparity(place));
  part.status.copyTo(whole.status(place));
}

std::string text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height) + " px";
}

/// No more is matched at once in the coarse levels than in a tile.
TileOptions tiles_of(cv::Size size) {
  TileOptions tiles;
  tiles.size = size;
  tiles.coarse_pixels = std::min(tiles.coarse_pixels, double{1} * size.width * size.height);
  return tiles;
}

/// What the whole process takes with tiles of a size.
class TilePlan {
 public:
  TilePlan(const Pipeline& pipeline, const MatchRequest& request, double held,
           const RunOptions& options)
      : trace_(RunTrace::of_memory(pipeline, request, options)),
        whole_(request.pair.size()),
        held_(held) {
    request_.load = workload_of(request, options.threads > 0 ? options.threads : thread_count());
  }

  double bytes(const TileOptions& tiles) const {
    PlanRequest request = request_;
    // Columns in which the other view may show the pixels of the tile are read and matched, too.
    const int aside = 2 * (tiles.halo + request.load.range.size());
    request.load.size = {std::min(whole_.width, tiles.size.width + aside),
                         std::min(whole_.height, tiles.size.height + 2 * tiles.halo)};
    return held_ + plan_run(trace_, request).peak_bytes;
  }

 private:
  RunTrace trace_;
  PlanRequest request_;
  cv::Size whole_;
  double held_;
};

TileOptions chosen(const Pipeline& pipeline, const MatchRequest& request, const SceneInputs& inputs,
                   const RunOptions& options) {
  const double free =
      static_cast<double>(available_memory()) + static_cast<double>(resident_memory());
  return fitting_tiles(pipeline, request, held(request, inputs), inputs.memory_limit.value_or(free),
                       options);
}

/// Throws UsageError if tiles of this size do not fit the limit, if there is one.
TileOptions checked(const Pipeline& pipeline, const MatchRequest& request,
                    const SceneInputs& inputs, const TileOptions& tiles,
                    const RunOptions& options) {
  if (!inputs.memory_limit) return tiles;
  const double bytes = TilePlan(pipeline, request, held(request, inputs), options).bytes(tiles);
  if (bytes <= *inputs.memory_limit) return tiles;
  throw UsageError("tiles of " + text(tiles.size) + " take " + bytes_text(bytes) +
                   ", and --memory-limit allows " + bytes_text(*inputs.memory_limit) +
                   "; give smaller ones, or --tiles auto");
}

}  // namespace

TileOptions fitting_tiles(const Pipeline& pipeline, const MatchRequest& request, double held,
                          double limit, const RunOptions& options) {
  const TilePlan plan(pipeline, request, held, options);
  const cv::Size whole = request.pair.size();
  for (int side = std::max(whole.width, whole.height);; side = side * 3 / 4) {
    const TileOptions tiles = tiles_of({side, side});
    if (plan.bytes(tiles) <= limit) return tiles;
    if (side <= kSmallestTile) break;
  }
  throw UsageError("images of " + text(whole) + " take " + bytes_text(held) +
                   " beside what their tiles take, and " + bytes_text(limit) +
                   " are allowed; raise --memory-limit, or match a part of the images");
}

MatchPair in_tiles(const Pipeline& pipeline, std::optional<cv::Size> size) {
  return [&pipeline, size](const MatchRequest& request, const SceneInputs& inputs,
                           const RunOptions& options) {
    const TileOptions tiles = size ? checked(pipeline, request, inputs, tiles_of(*size), options)
                                   : chosen(pipeline, request, inputs, options);
    if (options.observer != nullptr) {
      options.observer->log(LogLevel::info, {}, "matched in tiles of up to " + text(tiles.size));
    }
    MatchResult result{DisparityMap(request.pair.size()), std::nullopt};
    run_in_tiles(
        pipeline, {std::make_shared<PairInMemory>(request.pair), request.range}, tiles,
        [&](const cv::Rect& place, const DisparityMap& part) {
          paste(part, place, result.forward);
        },
        options);
    return result;
  };
}

}  // namespace xgm::tiles
