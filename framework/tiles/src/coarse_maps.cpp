// SPDX-License-Identifier: Apache-2.0
#include "coarse_maps.hpp"

#include <algorithm>
#include <cmath>

#include "reduced_pair.hpp"
#include "stereo_family.hpp"
#include "xgm/data/crop.hpp"
#include "xgm/data/halve.hpp"
#include "xgm/tiles/tiling.hpp"

namespace xgm::tiles {

int coarse_scale(const Pipeline& pipeline, cv::Size image, const TileOptions& tiles) {
  const int coarsest = stereo_family(pipeline).coarsest_scale();
  const double pixels = double{1} * image.width * image.height;
  int scale = std::min(2, coarsest);
  while (scale < coarsest && pixels / scale / scale > tiles.coarse_pixels) scale *= 2;
  return std::min(scale, coarsest);
}

std::optional<CoarseMaps> match_coarse(const Pipeline& pipeline, const TiledRequest& request,
                                       const TileOptions& tiles, const RunOptions& options) {
  CoarseMaps coarse;
  coarse.scale = coarse_scale(pipeline, request.pair->size(), tiles);
  if (coarse.scale == 1) return std::nullopt;
  DisparityRange range = request.range;
  for (int s = 1; s < coarse.scale; s *= 2) range = halve(range);
  MatchRequest whole{reduced_pair(*request.pair, coarse.scale), std::move(range), std::nullopt,
                     ScenePart{.scale = coarse.scale}};
  // With the facts of the full images: levels count from these here, too.
  coarse.maps = pipeline.run(whole, options);
  return coarse;
}

MatchResult part_of(const CoarseMaps& coarse, const cv::Rect& window) {
  return crop(coarse.maps, reduced(window, coarse.scale) - cv::Point(0, coarse.first_row));
}

cv::Range rows_needed(const cv::Rect& part, const TileOptions& tiles, cv::Size image, int scale) {
  constexpr Interval kAny{0, 1};  // decides of columns alone
  const cv::Rect window = reduced(surroundings(part, tiles.halo, kAny, image, scale).window, scale);
  return {window.y, window.br().y};
}

Interval likely(const CoarseMaps& coarse, const cv::Rect& place, Interval limits) {
  const DisparityMap& map = coarse.maps.forward;
  const cv::Rect seen(cv::Point(place.x / coarse.scale, place.y / coarse.scale - coarse.first_row),
                      cv::Point(reduced(place.br().x, coarse.scale),
                                reduced(place.br().y, coarse.scale) - coarse.first_row));
  float low = INFINITY, high = -INFINITY;
  for (int y = seen.y; y < seen.br().y; ++y) {
    for (int x = seen.x; x < seen.br().x; ++x) {
      if (!map.has_disparity(y, x)) continue;
      low = std::min(low, map.disparity(y, x));
      high = std::max(high, map.disparity(y, x));
    }
  }
  if (low > high) return limits;
  // Each finer level may go on by the relaxation of its search range, px of its own: from the
  // coarse level to the images that is less than the same number of coarse px. A margin of 5 is
  // enough for relaxations of up to 4, which the shipped pipelines do not exceed.
  constexpr float kMargin = 5;
  const auto scale = static_cast<float>(coarse.scale);
  const Interval found{cvFloor((low - kMargin) * scale), cvCeil((high + kMargin) * scale) + 1};
  const Interval both = intersect(found, limits);
  return both.empty() ? limits : both;
}

}  // namespace xgm::tiles
