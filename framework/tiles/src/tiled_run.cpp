// SPDX-License-Identifier: Apache-2.0
#include "xgm/tiles/tiled_run.hpp"

#include "coarse_maps.hpp"
#include "stereo_family.hpp"
#include "tiles_as_one.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/data/crop.hpp"
#include "xgm/data/image_parts.hpp"
#include "xgm/tiles/tiling.hpp"

namespace xgm::tiles {
namespace {

/// Share of the time that the levels above the tiles take, and what is done before them.
constexpr double kBeforeTiles = 0.1;

std::shared_ptr<const PairWindows> prepared(const Pipeline& pipeline, const TiledRequest& request,
                                            const RunOptions& options) {
  std::shared_ptr<const PairWindows> scene;
  pipeline.in_run(options, [&](const Context& context) {
    scene = stereo_family(pipeline).prepared(request.pair, context);
  });
  return scene;
}

/// The request's range within `place`, nothing elsewhere in the window.
DisparityRange range_in(const DisparityRange& range, const cv::Rect& place, const cv::Rect& window,
                        Interval hull) {
  return DisparityRange::of_pixels(window.size(), [&](int y, int x) {
    const cv::Point pixel = cv::Point(x, y) + window.tl();
    return place.contains(pixel) ? intersect(range.at(pixel.y, pixel.x), hull) : Interval{};
  });
}

class TiledRun {
 public:
  TiledRun(const Pipeline& pipeline, TiledRequest request, const TileOptions& tiles,
           const RunOptions& options)
      : pipeline_(pipeline), request_(std::move(request)), tiles_(tiles), options_(options) {}

  void run(const TakePart& take) {
    TilesAsOne observer(options_.observer);
    RunOptions watched = options_;
    watched.observer = &observer;
    observer.next(0, kBeforeTiles / 2, false);
    request_.pair = prepared(pipeline_, request_, watched);
    observer.next(kBeforeTiles / 2, kBeforeTiles, false);
    coarse_ = match_coarse(pipeline_, request_, tiles_, watched);
    trim_heap();
    const std::vector<cv::Rect> all = image_parts(request_.pair->size(), tiles_.size, alignment());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double each = (1 - kBeforeTiles) / static_cast<double>(all.size());
      const double begin = kBeforeTiles + each * static_cast<double>(i);
      observer.next(begin, begin + each, true);
      take(all[i], match(all[i], watched));
    }
    observer.finish();
  }

 private:
  int alignment() const { return coarse_ ? coarse_->scale : 1; }

  DisparityMap match(const cv::Rect& core, const RunOptions& options) const {
    const cv::Size size = request_.pair->size();
    Interval hull = request_.range.hull();
    if (coarse_) hull = likely(*coarse_, surroundings(core, tiles_.halo, {}, size).searched, hull);
    const Surroundings around = surroundings(core, tiles_.halo, hull, size, alignment());
    const DisparityMap map = pipeline_.run(request_of(around, hull), options).forward;
    return crop(map, core - around.window.tl());
  }

  MatchRequest request_of(const Surroundings& around, Interval hull) const {
    const cv::Rect& window = around.window;
    ScenePart part;
    if (coarse_) part = {.coarse = part_of(*coarse_, window), .coarse_scale = coarse_->scale};
    ImagePair pair = request_.pair->read(window);
    if (!pipeline_.accepts_range_maps()) {
      return {std::move(pair), DisparityRange::uniform(window.size(), hull), std::nullopt,
              std::move(part)};
    }
    const DisparityRange forward = range_in(request_.range, around.searched, window, hull);
    return {std::move(pair), forward, reverse_range(around, hull), std::move(part)};
  }

  /// What the partners of the pixels in the window search, as far as it is wanted.
  DisparityRange reverse_range(const Surroundings& around, Interval hull) const {
    const cv::Rect& window = around.window;
    const DisparityRange all =
        request_.range.is_uniform()
            ? DisparityRange::uniform(window.size(), {1 - hull.end, 1 - hull.begin})
            : range_in(request_.range, window, window, hull).reversed();
    return range_in(all, around.reverse_searched - window.tl(), cv::Rect({}, window.size()),
                    all.hull());
  }

  const Pipeline& pipeline_;
  TiledRequest request_;
  TileOptions tiles_;
  RunOptions options_;
  std::optional<CoarseMaps> coarse_;
};

}  // namespace

const StereoFamily& stereo_family(const Pipeline& pipeline) {
  const auto* const family = dynamic_cast<const StereoFamily*>(&pipeline.family());
  if (family == nullptr) throw UsageError(pipeline.file() + ": matches no single pair of images");
  return *family;
}

void run_in_tiles(const Pipeline& pipeline, const TiledRequest& request, const TileOptions& tiles,
                  const TakePart& take, const RunOptions& options) {
  TiledRun(pipeline, request, tiles, options).run(take);
}

}  // namespace xgm::tiles
