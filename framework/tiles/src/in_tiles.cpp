// SPDX-License-Identifier: Apache-2.0
#include "xgm/tiles/in_tiles.hpp"

#include "choose_tiles.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/text.hpp"
#include "xgm/io/write_maps.hpp"
#include "xgm/stage/kept_results.hpp"

namespace xgm::tiles {
namespace {

TiledRequest request_of(const SceneInputs& inputs) {
  const Scene& scene = inputs.scene;
  if (scene.windows) return {scene.windows, inputs.range};
  return {std::make_shared<PairInMemory>(scene.pair), inputs.range};
}

/// With the images, the truth and the map as a whole, unless these are read and written by windows.
Besides besides_of(const SceneInputs& inputs) {
  Besides besides = inputs.besides;
  besides.level_pixel = 0;  // levels are not kept
  if (inputs.scene.windows) return besides;
  const auto bytes = [](const cv::Mat& map) {
    return static_cast<double>(map.total() * map.elemSize());
  };
  for (const Image* image : {&inputs.scene.pair.base, &inputs.scene.pair.match}) {
    for (const cv::Mat1f& plane : image->planes) besides.held += bytes(plane);
    besides.held += bytes(image->valid);
  }
  const GroundTruth& truth = inputs.scene.truth;
  besides.held += bytes(truth.disparity) + bytes(truth.reverse) + bytes(truth.non_occluded) +
                  bytes(truth.objects);
  constexpr double kMapBytes = 5;
  besides.held += kMapBytes * inputs.scene.size().area();
  return besides;
}

Besides besides_of_whole(const SceneInputs& inputs) {
  return inputs.scene.windows ? Besides{.after = bytes_to_write_maps(inputs.scene.size())}
                              : inputs.besides;
}

double free_bytes() {
  return static_cast<double>(available_memory()) + static_cast<double>(resident_memory());
}

TileOptions without_limit(cv::Size size) {
  TileOptions tiles = tiles_of_size(size);
  tiles.keeps_memory = true;
  return tiles;
}

/// What an earlier run of the same question has decided, which may have found other memory free.
/// None: the whole is matched.
std::optional<TileOptions> decided(const RunOptions& options,
                                   const std::function<std::optional<TileOptions>()>& decide) {
  if (options.kept == nullptr) return decide();
  const Json kept = options.kept->decided("tiles", [&] {
    const std::optional<TileOptions> tiles = decide();
    if (!tiles) return Json();
    return Json(std::vector<int>{tiles->size.width, tiles->size.height, tiles->keeps_memory});
  });
  if (kept.size() != 3) return std::nullopt;
  const auto number = [&](std::size_t i) { return static_cast<int>(kept.elements()[i].number()); };
  TileOptions tiles = tiles_of_size({number(0), number(1)});
  tiles.keeps_memory = number(2) != 0;
  return tiles;
}

MatchParts match_in(const Pipeline& pipeline, TiledRequest request, const TileOptions& tiles,
                    const std::string& reason, const RunOptions& options) {
  if (options.observer != nullptr) {
    options.observer->log(LogLevel::info, {},
                          reason + "matched in tiles of up to " + size_text(tiles.size));
  }
  return [&pipeline, request = std::move(request), tiles](const TakePart& take,
                                                          const RunOptions& watched) {
    run_in_tiles(pipeline, request, tiles, take, watched);
  };
}

}  // namespace

TileOptions fitting_tiles(const Pipeline& pipeline, const TiledRequest& request,
                          const Besides& besides, double limit, const RunOptions& options) {
  return fitting(TilePlan(pipeline, request, besides, options), request.pair->size(), limit);
}

ChooseParts in_tiles(const Pipeline& pipeline, std::optional<cv::Size> size) {
  return [&pipeline, size](const SceneInputs& inputs, const RunOptions& options) {
    TiledRequest request = request_of(inputs);
    const auto tiles = decided(options, [&]() -> std::optional<TileOptions> {
      if (size && !inputs.memory_limit) return without_limit(*size);
      const TilePlan plan(pipeline, request, besides_of(inputs), options);
      const double limit = inputs.memory_limit.value_or(free_bytes());
      return size ? checked(plan, *size, limit) : fitting(plan, inputs.scene.size(), limit);
    });
    return match_in(pipeline, std::move(request), tiles.value(), "", options);
  };
}

ChooseParts in_tiles_if_needed(const Pipeline& pipeline) {
  return [&pipeline](const SceneInputs& inputs, const RunOptions& options) -> MatchParts {
    const double limit = inputs.memory_limit.value_or(free_bytes());
    TiledRequest request = request_of(inputs);
    std::string reason;
    const auto tiles = decided(options, [&]() -> std::optional<TileOptions> {
      const TilePlan plan(pipeline, request, besides_of(inputs), options);
      const double whole =
          plan.bytes_of_whole(besides_of_whole(inputs), !inputs.scene.truth.disparity.empty());
      if (whole <= limit) return std::nullopt;
      reason = "the whole takes " + bytes_text(whole) + ", and --memory-limit allows " +
               bytes_text(limit) + ": ";
      return fitting(plan, inputs.scene.size(), limit);
    });
    if (!tiles) return {};
    return match_in(pipeline, std::move(request), *tiles, reason, options);
  };
}

}  // namespace xgm::tiles
