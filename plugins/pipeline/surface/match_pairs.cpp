// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/surface/match_pairs.hpp"

#include "plugins/pipeline/surface/cloud.hpp"
#include "plugins/pipeline/surface/coarse.hpp"
#include "plugins/pipeline/surface/grid.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/data/image_parts.hpp"
#include "xgm/geo/image/kept_window.hpp"
#include "xgm/geo/image/resample.hpp"
#include "xgm/stage/needs.hpp"

namespace xgm::geo {
namespace {

/// A window of a base image, and the heights of the ground there.
struct Part {
  cv::Rect window;
  HeightInterval heights;
};

double cells_of(const DisparityRange& range) {
  double cells = 0;
  for (int y = 0; y < range.size().height; ++y) {
    for (int x = 0; x < range.size().width; ++x) cells += Workload::room(range.at(y, x).size());
  }
  return cells;
}

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
    double begin = prepare(images, pairs, context);
    const double each = (1 - begin) / static_cast<double>(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i, begin += each) {
      matched_.clouds.push_back(match_pair(i, context.part(begin, begin + each)));
    }
    return std::move(matched_);
  }

  WorkAhead look_ahead(const std::vector<SatelliteImage>& images,
                       const std::vector<PairChoice>& pairs, const Context& context) {
    WorkAhead ahead;
    prepare(images, pairs, context);
    std::optional<Window> largest;
    std::size_t pair_of_largest = 0;
    double most = -1;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const SeenPair& pair = matched_.seen[i];
      const Context here = of_pair(context, pair.base, pair.match);
      for (const Part& part : parts_[i]) {
        Window window = open(pair, part, here);
        const double cells = cells_of(window.range);
        ahead.windows.push_back({window.range.size(), part.window.size(), cells});
        if (cells <= most) continue;
        most = cells;
        largest = std::move(window);
        pair_of_largest = i;
      }
    }
    const SeenPair& pair = matched_.seen[pair_of_largest];
    ahead.largest = {
        resample(largest->pair, find_grey_scale(pair.base), find_grey_scale(pair.match)),
        std::move(largest->range),
        {}};
    return ahead;
  }

 private:
  /// What is known of a window before it is matched.
  struct Window {
    RectifiedPair pair;
    DisparityRange range;
  };

  /// Finds the windows, and the coarser surface if one is asked for. Returns which share of the
  /// work that is.
  double prepare(const std::vector<SatelliteImage>& images, const std::vector<PairChoice>& pairs,
                 const Context& context) {
    const Slot<RangePrior>* coarse_prior = nullptr;
    for (const PairChoice& pair : pairs) {
      const SatelliteImage &base = images[pair.base], &match = images[pair.match];
      parts_.push_back(parts_of(base, match, context));
      for (const Part& part : parts_.back()) {
        if (coarse_prior != nullptr) break;
        coarse_prior = prior_->coarse_prior(base, match, part.heights, request_.dem.get());
      }
      matched_.seen.push_back({base, match, {}});
    }
    if (coarse_prior == nullptr) return 0;
    constexpr double kShare = 0.1;  // of the time, about
    coarse_ =
        coarse_surface(stages_, *coarse_prior, request_, images, pairs, context.part(0, kShare));
    return kShare;
  }

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

  PointCloud match_pair(std::size_t index, const Context& context) {
    SeenPair& pair = matched_.seen[index];
    const std::vector<Part>& parts = parts_[index];
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

  Window open(const SeenPair& seen, const Part& part, const Context& context) const {
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
    trim_heap();  // key points leave hundreds of MB behind
    return {std::move(pair), std::move(range)};
  }

  void match_part(SeenPair& seen, const Part& part, const GreyScale& base_scale,
                  const GreyScale& match_scale, const Context& context, PointCloud& cloud) const {
    Window window = open(seen, part, context);
    const RectifiedPair& pair = window.pair;
    const MatchRequest matching{
        resample(pair, base_scale, match_scale), std::move(window.range), {}};
    const DisparityMap map = matched(matching, context);
    if (request_.matched) request_.matched(pair, map);
    const PointGrid points = stages_.triangulation(context, pair, map);
    append(cloud, points, map, matching.pair.base.planes.front(), *pair.geometry, part.window);
    seen.windows.push_back(remember(part.window, pair, matching, map, points));
  }

  DisparityMap matched(const MatchRequest& request, const Context& context) const {
    if (request.range.hull().empty()) return DisparityMap(request.pair.size());
    return kept_window(request, context, [&] {
      DisparityMap map = stages_.matching(context, request).forward;
      for (const auto& filter : stages_.filters) map = filter(context, map, request.pair);
      return map;
    });
  }

  const SurfaceStages& stages_;
  const Slot<RangePrior>& prior_;
  const SurfaceRequest& request_;
  std::optional<Raster> coarse_;
  std::vector<std::vector<Part>> parts_;  ///< of each pair
  MatchedPairs matched_;
};

}  // namespace

MatchedPairs match_pairs(const SurfaceStages& stages, const Slot<RangePrior>& prior,
                         const SurfaceRequest& request, const std::vector<SatelliteImage>& images,
                         const std::vector<PairChoice>& pairs, const Context& context) {
  return Matching(stages, prior, request).run(images, pairs, context);
}

WorkAhead look_ahead(const SurfaceStages& stages, const SurfaceRequest& request,
                     const std::vector<SatelliteImage>& images,
                     const std::vector<PairChoice>& pairs, const Context& context) {
  return Matching(stages, stages.range_prior, request).look_ahead(images, pairs, context);
}

}  // namespace xgm::geo
