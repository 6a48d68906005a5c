// SPDX-License-Identifier: Apache-2.0
#include "tile_plan.hpp"

#include <algorithm>

#include "coarse_maps.hpp"
#include "reduced_pair.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/data/interval_mapping.hpp"
#include "xgm/stage/preprocess.hpp"

namespace xgm::tiles {
namespace {

constexpr double kMapBytes = 5;
constexpr double kRangeBytes = 8;
// Tiles differ in size and in what they search, so that what one leaves is not of use for the next:
// measured beside the plan, 20 to 30 MB stay in the heap, whatever the size.
constexpr double kLeftByTiles = 30e6;

/// The question at a size that does not matter beside what is planned; RunTrace makes it half as
/// large.
MatchRequest small_request(const TiledRequest& request) {
  constexpr double kPixels = 1.6e6;
  const cv::Size size = request.pair->size();
  int scale = 1;
  while (double{1} * size.width * size.height / scale / scale > kPixels) scale *= 2;
  ImagePair pair = reduced_pair(*request.pair, scale);
  const Interval range = divided(request.range.hull(), scale);
  const cv::Size small = pair.size();
  return {std::move(pair), DisparityRange::uniform(small, range), std::nullopt};
}

Workload load_of(const MatchRequest& small, const TiledRequest& request,
                 const RunOptions& options) {
  const int threads = options.threads > 0 ? options.threads : thread_count();
  const Workload reduced = workload_of(small, threads);
  Workload load = workload_of(request.range, reduced.planes, {}, threads);
  load.masked = reduced.masked;
  load.used = reduced.used;
  return load;
}

bool is_preprocess(const PlannedStage& stage) { return stage.place.kind == Preprocess::kKind; }

}  // namespace

double matching_seconds(const RunPlan& plan) {
  double seconds = 0;
  for (const PlannedStage& stage : plan.stages) {
    if (!is_preprocess(stage)) seconds += stage.seconds;
  }
  return seconds;
}

TilePlan::TilePlan(const Pipeline& pipeline, const TiledRequest& request, const Besides& besides,
                   const RunOptions& options, PlanOf what)
    : TilePlan(pipeline, small_request(request), request, besides, options, what) {}

TilePlan::TilePlan(const Pipeline& pipeline, const MatchRequest& small, const TiledRequest& request,
                   const Besides& besides, const RunOptions& options, PlanOf what)
    : pipeline_(pipeline),
      load_(load_of(small, request, options)),
      trace_(what == PlanOf::memory ? RunTrace::of_memory(pipeline, small, options)
                                    : RunTrace::of_reduced(pipeline, small, options)),
      besides_(besides) {
  besides_.held += static_cast<double>(request.range.bytes());
  trim_heap();  // or what the small run and the looks at the images leave counts twice
}

RunPlan TilePlan::plan_of(cv::Size size, Interval range, double used, double held,
                          bool volumes_stay) const {
  PlanRequest request{.load = load_, .besides = besides_};
  request.besides.volumes_stay = volumes_stay;
  request.load.size = size;
  request.load.range = range;
  request.load.used = used;
  request.load.cells_per_pixel = std::min(load_.cells_per_pixel, Workload::room(range.size()));
  request.besides.held += held;
  return plan_run(trace_, request);
}

int TilePlan::scale_of(const TileOptions& tiles) const {
  return coarse_scale(pipeline_, load_.size, tiles);
}

RunPlan TilePlan::tile(const TileOptions& tiles) const {
  const int scale = scale_of(tiles);
  // Columns in which the other view may show the pixels of the tile are read and matched, too.
  const int aside = 2 * (tiles.halo + load_.range.size());
  const cv::Size tile(std::min(load_.size.width, tiles.size.width + aside),
                      std::min(load_.size.height, tiles.size.height + 2 * tiles.halo));
  const double ranges =
      pipeline_.accepts_range_maps() ? 2 * kRangeBytes * tile.width * tile.height : 0;
  const double coarse_maps =
      scale == 1 ? 0 : 2 * kMapBytes * load_.size.width * load_.size.height / scale / scale;
  constexpr double kAll = 1;  // of the fullest tile, whatever the scene lacks
  return plan_of(tile, load_.range, kAll, kLeftByTiles + ranges + coarse_maps, tiles.keeps_memory);
}

TilePlan::Fit TilePlan::fit() const {
  // Stages look at a whole scene by windows; they hold no more at once than of so large a scene.
  const cv::Size windows(std::min(load_.size.width, 2048), std::min(load_.size.height, 2048));
  Fit fit;
  for (const PlannedStage& stage : plan_of(windows, load_.range, load_.used, 0).stages) {
    if (is_preprocess(stage)) fit.bytes = std::max(fit.bytes, stage.memory);
  }
  const RunPlan whole = plan_of(load_.size, load_.range, load_.used, 0);
  fit.seconds = whole.seconds - matching_seconds(whole);
  return fit;
}

RunPlan TilePlan::coarse(const TileOptions& tiles) const {
  const int scale = scale_of(tiles);
  return plan_of({reduced(load_.size.width, scale), reduced(load_.size.height, scale)},
                 divided(load_.range, scale), load_.used, 0);
}

double TilePlan::bytes(const TileOptions& tiles) const {
  const double of_tile = tile(tiles).peak_bytes;
  return scale_of(tiles) == 1 ? of_tile : std::max(of_tile, coarse(tiles).peak_bytes);
}

double TilePlan::bytes_of_whole(const Besides& besides, bool truth) const {
  return plan_run(trace_, {.load = load_, .truth = truth, .besides = besides}).peak_bytes;
}

}  // namespace xgm::tiles
