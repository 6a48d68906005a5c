// SPDX-License-Identifier: Apache-2.0
#include "tiled_match.hpp"

#include "stereo_family.hpp"
#include "xgm/data/crop.hpp"
#include "xgm/data/image_parts.hpp"

namespace xgm::tiles {
namespace {

/// The request's range within `place`, nothing elsewhere in the window.
DisparityRange range_in(const DisparityRange& range, const cv::Rect& place, const cv::Rect& window,
                        Interval hull) {
  return DisparityRange::of_pixels(window.size(), [&](int y, int x) {
    const cv::Point pixel = cv::Point(x, y) + window.tl();
    return place.contains(pixel) ? intersect(range.at(pixel.y, pixel.x), hull) : Interval{};
  });
}

}  // namespace

const StereoFamily& stereo_family(const Pipeline& pipeline) {
  const auto* const family = dynamic_cast<const StereoFamily*>(&pipeline.family());
  if (family == nullptr) throw UsageError(pipeline.file() + ": matches no single pair of images");
  return *family;
}

std::vector<std::string> names_of(const std::vector<cv::Rect>& parts) {
  std::vector<std::string> names;
  int row = 0, column = 0;
  for (const cv::Rect& part : parts) {
    column = part.x == 0 ? 1 : column + 1;
    if (part.x == 0) ++row;
    names.push_back("tile_" + std::to_string(row) + "_" + std::to_string(column));
  }
  return names;
}

void TiledMatch::prepare(const RunOptions& options) {
  pipeline_.in_run(options, [&](const Context& context) {
    request_.pair = stereo_family(pipeline_).prepared(request_.pair, context);
  });
}

std::string TiledMatch::find_on_whole(const RunOptions& options) const {
  std::string found;
  pipeline_.in_run(options, [&](const Context& context) {
    found = stereo_family(pipeline_).found_on_whole(request_.pair, context);
  });
  return found;
}

void TiledMatch::prepare_with(const std::string& found, const RunOptions& options) {
  pipeline_.in_run(options, [&](const Context& context) {
    request_.pair = stereo_family(pipeline_).prepared_with(found, request_.pair, context);
  });
}

bool TiledMatch::has_coarse() const {
  return coarse_scale(pipeline_, request_.pair->size(), tiles_) > 1;
}

void TiledMatch::match_coarse(const RunOptions& options) {
  coarse_ = tiles::match_coarse(pipeline_, request_, tiles_, options);
}

void TiledMatch::use(MatchResult coarse) {
  use(CoarseMaps{.scale = coarse_scale(pipeline_, request_.pair->size(), tiles_),
                 .maps = std::move(coarse)});
}

std::vector<cv::Rect> TiledMatch::parts() const {
  return image_parts(request_.pair->size(), tiles_.size,
                     coarse_scale(pipeline_, request_.pair->size(), tiles_));
}

DisparityMap TiledMatch::match(const cv::Rect& part, const RunOptions& options) const {
  const cv::Size size = request_.pair->size();
  Interval hull = request_.range.hull();
  if (coarse_) hull = likely(*coarse_, surroundings(part, tiles_.halo, {}, size).searched, hull);
  const Surroundings around =
      surroundings(part, tiles_.halo, hull, size, coarse_ ? coarse_->scale : 1);
  RunOptions here = options;
  std::optional<Calibration>& calibration = here.facts.calibration;
  if (calibration) calibration = moved(*calibration, around.window.x, around.window.y);
  const DisparityMap map = pipeline_.run(request_of(around, hull), here).forward;
  return crop(map, part - around.window.tl());
}

MatchRequest TiledMatch::request_of(const Surroundings& around, Interval hull) const {
  const cv::Rect& window = around.window;
  ScenePart place;
  if (coarse_) place = {.coarse = part_of(*coarse_, window), .coarse_scale = coarse_->scale};
  ImagePair pair = request_.pair->read(window);
  if (!pipeline_.accepts_range_maps()) {
    return {std::move(pair), DisparityRange::uniform(window.size(), hull), std::nullopt,
            std::move(place)};
  }
  const DisparityRange forward = range_in(request_.range, around.searched, window, hull);
  return {std::move(pair), forward, reverse_range(around, hull), std::move(place)};
}

/// What the partners of the pixels in the window search, as far as it is wanted.
DisparityRange TiledMatch::reverse_range(const Surroundings& around, Interval hull) const {
  const cv::Rect& window = around.window;
  const DisparityRange all =
      request_.range.is_uniform()
          ? DisparityRange::uniform(window.size(), {1 - hull.end, 1 - hull.begin})
          : range_in(request_.range, window, window, hull).reversed();
  return range_in(all, around.reverse_searched - window.tl(), cv::Rect({}, window.size()),
                  all.hull());
}

}  // namespace xgm::tiles
