// SPDX-License-Identifier: Apache-2.0
#include "coarse_maps.hpp"

#include <algorithm>
#include <cmath>

#include "stereo_family.hpp"
#include "xgm/data/crop.hpp"
#include "xgm/data/halve.hpp"

namespace xgm::tiles {
namespace {

int reduced(int length, int scale) { return (length + scale - 1) / scale; }

cv::Rect reduced(const cv::Rect& window, int scale) {
  return {window.x / scale, window.y / scale, reduced(window.width, scale),
          reduced(window.height, scale)};
}

/// The finest scale of the pyramid whose level has no more pixels than are allowed.
int scale_of_whole(int coarsest, cv::Size image, double pixels) {
  int scale = 2;
  while (scale<coarsest&& double{1} * image.width * image.height / scale / scale> pixels) {
    scale *= 2;
  }
  return std::min(scale, coarsest);
}

void paste(const Image& part, const cv::Rect& place, cv::Size size, Image& whole) {
  if (whole.planes.empty()) {
    for (std::size_t k = 0; k < part.planes.size(); ++k) whole.planes.emplace_back(size);
  }
  for (std::size_t k = 0; k < part.planes.size(); ++k)
    part.planes[k].copyTo(whole.planes[k](place));
  if (part.valid.empty() && whole.valid.empty()) return;
  if (whole.valid.empty()) whole.valid = cv::Mat1b(size, std::uint8_t{255});
  if (part.valid.empty()) {
    whole.valid(place).setTo(255);
  } else {
    part.valid.copyTo(whole.valid(place));
  }
}

/// Both images `scale` times smaller, read in bands of rows that hold whole blocks of pixels.
ImagePair reduced_pair(const PairWindows& pair, int scale) {
  constexpr int kRows = 256;
  const cv::Size size = pair.size();
  const cv::Size small(reduced(size.width, scale), reduced(size.height, scale));
  const int band = std::max(kRows, scale);
  ImagePair whole;
  for (int y = 0; y < size.height; y += band) {
    const cv::Rect window(0, y, size.width, std::min(band, size.height - y));
    ImagePair part = pair.read(window);
    for (int s = 1; s < scale; s *= 2)
      part = {halve(part.base), halve(part.match), part.is_reverse};
    const cv::Rect place = reduced(window, scale);
    paste(part.base, place, small, whole.base);
    paste(part.match, place, small, whole.match);
    whole.is_reverse = part.is_reverse;
  }
  return whole;
}

}  // namespace

std::optional<CoarseMaps> match_coarse(const Pipeline& pipeline, const TiledRequest& request,
                                       const TileOptions& tiles, const RunOptions& options) {
  const int coarsest = stereo_family(pipeline).coarsest_scale();
  if (coarsest == 1) return std::nullopt;
  CoarseMaps coarse;
  coarse.scale = scale_of_whole(coarsest, request.pair->size(), tiles.coarse_pixels);
  DisparityRange range = request.range;
  for (int s = 1; s < coarse.scale; s *= 2) range = halve(range);
  MatchRequest whole{reduced_pair(*request.pair, coarse.scale), std::move(range), std::nullopt,
                     ScenePart{.scale = coarse.scale}};
  coarse.maps = pipeline.run(whole, options);
  return coarse;
}

MatchResult part_of(const CoarseMaps& coarse, const cv::Rect& window) {
  return crop(coarse.maps, reduced(window, coarse.scale));
}

Interval likely(const CoarseMaps& coarse, const cv::Rect& place, Interval limits) {
  const DisparityMap& map = coarse.maps.forward;
  const cv::Rect seen(
      cv::Point(place.x / coarse.scale, place.y / coarse.scale),
      cv::Point(reduced(place.br().x, coarse.scale), reduced(place.br().y, coarse.scale)));
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
