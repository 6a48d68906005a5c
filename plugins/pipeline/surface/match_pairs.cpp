// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/surface/match_pairs.hpp"

#include "plugins/pipeline/surface/cloud.hpp"
#include "plugins/pipeline/surface/coarse.hpp"
#include "plugins/pipeline/surface/grid.hpp"
#include "xgm/data/image_parts.hpp"
#include "xgm/geo/image/resample.hpp"

namespace xgm::geo {
namespace {

/// A window of a base image, and the heights of the ground there.
struct Part {
  cv::Rect window;
  HeightInterval heights;
};

/// How many disparities a pixel has to search, and what they are in heights, for the record.
void record_widths(const RectifiedPair& pair, const DisparityRange& range, const Context& context) {
  double sum = 0;
  for (int y = 0; y < range.size().height; ++y) {
    for (int x = 0; x < range.size().width; ++x) sum += range.at(y, x).size();
  }
  const double mean = sum / static_cast<double>(range.size().area());
  context.figure("searched_px", mean);
  const double pixels = parallax(pair.base, pair.match, pair.heights);
  if (pixels > 0) {
    context.figure("searched_m", mean * (pair.heights.max - pair.heights.min) / pixels);
  }
}

class Matching {
 public:
  Matching(const SurfaceStages& stages, const Slot<RangePrior>& prior,
           const SurfaceRequest& request)
      : stages_(stages), prior_(prior), request_(request) {}

  MatchedPairs run(const std::vector<SatelliteImage>& images, const std::vector<PairChoice>& pairs,
                   const Context& context) {
    MatchedPairs matched;
    std::vector<std::vector<Part>> parts;
    const Slot<RangePrior>* coarse_prior = nullptr;
    for (const PairChoice& pair : pairs) {
      const SatelliteImage &base = images[pair.base], &match = images[pair.match];
      parts.push_back(parts_of(base, match, context));
      for (const Part& part : parts.back()) {
        if (coarse_prior != nullptr) break;
        coarse_prior = prior_->coarse_prior(base, match, part.heights, request_.dem.get());
      }
      matched.seen.push_back({base, match, {}});
    }
    double begin = 0;
    if (coarse_prior != nullptr) {
      constexpr double kShare = 0.1;  // of the time, about
      begin = kShare;
      coarse_ =
          coarse_surface(stages_, *coarse_prior, request_, images, pairs, context.part(0, kShare));
    }
    const double each = (1 - begin) / static_cast<double>(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i, begin += each) {
      matched.clouds.push_back(
          match_pair(matched.seen[i], parts[i], context.part(begin, begin + each)));
    }
    return matched;
  }

 private:
  static Context of_pair(const Context& context, const SatelliteImage& base,
                         const SatelliteImage& match) {
    return context.scope(base.name + "_" + match.name);
  }
  static Context of_part(const Context& pair, std::size_t i, std::size_t count) {
    return count > 1 ? pair.scope("tile_" + std::to_string(i + 1)) : pair;
  }

  std::vector<Part> parts_of(const SatelliteImage& base, const SatelliteImage& match,
                             const Context& context) const {
    const Context here = of_pair(context, base, match);
    const cv::Rect whole = window_of(request_, base);
    const std::vector<cv::Rect> windows = image_parts(whole.size(), {stages_.tile, stages_.tile});
    std::vector<Part> parts;
    for (std::size_t i = 0; i < windows.size(); ++i) {
      const cv::Rect window = windows[i] + whole.tl();
      parts.push_back({window, prior_->heights(base, match, window, request_.dem.get(),
                                               of_part(here, i, windows.size()))});
    }
    return parts;
  }

  PointCloud match_pair(SeenPair& pair, const std::vector<Part>& parts,
                        const Context& context) const {
    const Context here = of_pair(context, pair.base, pair.match);
    const GreyScale base_scale = find_grey_scale(pair.base),
                    match_scale = find_grey_scale(pair.match);
    PointCloud cloud;
    cloud.base = pair.base.name;
    cloud.match = pair.match.name;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const double n = static_cast<double>(parts.size());
      const Context tile = here.part(static_cast<double>(i) / n, static_cast<double>(i + 1) / n);
      match_part(pair, parts[i], base_scale, match_scale, of_part(tile, i, parts.size()), cloud);
    }
    return cloud;
  }

  void match_part(SeenPair& seen, const Part& part, const GreyScale& base_scale,
                  const GreyScale& match_scale, const Context& context, PointCloud& cloud) const {
    const cv::Rect& window = part.window;
    RectifiedPair pair{seen.base, seen.match, part.heights, nullptr};
    // More than the window, so that what lies at its border is matched with what is around it.
    constexpr int kCollar = 64;  // px
    const cv::Rect around = cv::Rect(window.tl() - cv::Point(kCollar, kCollar),
                                     window.size() + cv::Size(2 * kCollar, 2 * kCollar)) &
                            cv::Rect({}, seen.base.size);
    pair.geometry = stages_.rectification(context, seen.base, seen.match, around, pair.heights);
    DisparityRange range =
        prior_(context, pair, KnownSurfaces{request_.dem.get(), coarse_ ? &*coarse_ : nullptr});
    record_widths(pair, range, context);
    const MatchRequest matching{resample(pair, base_scale, match_scale), std::move(range), {}};
    const DisparityMap map = matched(matching, context);
    if (request_.matched) request_.matched(pair, map);
    const PointGrid points = stages_.triangulation(context, pair, map);
    append(cloud, points, map, matching.pair.base.planes.front(), *pair.geometry, window);
    seen.windows.push_back(remember(window, pair, matching, map, points));
  }

  DisparityMap matched(const MatchRequest& request, const Context& context) const {
    if (request.range.hull().empty()) return DisparityMap(request.pair.size());
    DisparityMap map = stages_.matching(context, request).forward;
    for (const auto& filter : stages_.filters) map = filter(context, map, request.pair);
    return map;
  }

  const SurfaceStages& stages_;
  const Slot<RangePrior>& prior_;
  const SurfaceRequest& request_;
  std::optional<Raster> coarse_;
};

}  // namespace

MatchedPairs match_pairs(const SurfaceStages& stages, const Slot<RangePrior>& prior,
                         const SurfaceRequest& request, const std::vector<SatelliteImage>& images,
                         const std::vector<PairChoice>& pairs, const Context& context) {
  return Matching(stages, prior, request).run(images, pairs, context);
}

}  // namespace xgm::geo
