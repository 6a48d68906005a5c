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

}  // namespace

TileOptions fitting_tiles(const Pipeline& pipeline, const MatchRequest& request, double held,
                          double limit, const RunOptions& options) {
  TileOptions tiles;
  const RunTrace trace = RunTrace::of_memory(pipeline, request, options);
  PlanRequest plan{
      .load = workload_of(request, options.threads > 0 ? options.threads : thread_count())};
  const cv::Size whole = request.pair.size();
  for (int side = std::max(whole.width, whole.height);; side = side * 3 / 4) {
    tiles.size = {side, side};
    plan.load.size = {std::min(whole.width, side + 2 * tiles.halo),
                      std::min(whole.height, side + 2 * tiles.halo)};
    if (held + plan_run(trace, plan).peak_bytes <= limit) return tiles;
    if (side <= kSmallestTile) break;
  }
  throw UsageError("images of " + text(whole) + " take " + bytes_text(held) +
                   " beside what their tiles take, and " + bytes_text(limit) +
                   " are allowed; raise --memory-limit, or match a part of the images");
}

MatchPair in_tiles(const Pipeline& pipeline, std::optional<cv::Size> size) {
  return [&pipeline, size](const MatchRequest& request, const SceneInputs& inputs,
                           const RunOptions& options) {
    TileOptions tiles;
    if (size) {
      tiles.size = *size;
    } else {
      const double free =
          static_cast<double>(available_memory()) + static_cast<double>(resident_memory());
      tiles = fitting_tiles(pipeline, request, held(request, inputs),
                            inputs.memory_limit.value_or(free), options);
    }
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
