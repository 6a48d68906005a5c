// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/surface/possible.hpp"

#include <algorithm>

#include "plugins/pipeline/surface/grid.hpp"
#include "xgm/geo/image/footprint.hpp"
#include "xgm/geo/stage/range_prior.hpp"

namespace xgm::geo {
namespace {

/// Lines of sight must meet at an angle: with less, a pixel is hundreds of metres of height.
bool stand_apart(const SatelliteImage& base, const SatelliteImage& match) {
  constexpr double kSmallest = 0.1;  // degrees
  const auto here = base.camera.ray({base.size.width / 2.0, base.size.height / 2.0});
  if (!here) return true;  // another check tells that this camera sees no ground
  const GeoPoint ground = to_geodetic(here->origin);
  const auto there = match.camera.ray(match.camera.project(ground));
  return !there || angle_between(*here, *there) >= kSmallest;
}

std::string outside(const SurfaceRequest& request, const SatelliteImage& base) {
  const auto shown = footprint(base, cv::Rect({}, base.size), base.camera.heights());
  std::string text = base.file + ": shows nothing of the requested area";
  if (!request.area || !shown) return text + "; choose another area, or leave it out";
  text += " (" + to_string(*request.area) + "); it shows " + to_string(*shown);
  if (intersect(swapped(*request.area), *shown)) {
    text += "; write longitudes first: WEST,SOUTH,EAST,NORTH";
  }
  return text;
}

/// How much of the window the DEM leaves out, and where.
void warn_of_gaps(const SatelliteImage& image, const cv::Rect& window, const HeightField& dem,
                  const Context& context) {
  const DemCoverage seen = dem_coverage(image, window, dem);
  if (seen.gaps.empty()) return;
  cv::Point low = window.br(), high = window.tl();
  for (const cv::Point& gap : seen.gaps) {
    low = {std::min(low.x, gap.x), std::min(low.y, gap.y)};
    high = {std::max(high.x, gap.x), std::max(high.y, gap.y)};
  }
  std::string text = "the DEM has no heights for " +
                     std::to_string(std::max(1, cvRound(100 * (1 - seen.share)))) + " % of what " +
                     image.file + " shows";
  const auto where =
      footprint(image, cv::Rect(low, high + cv::Point(1, 1)), {seen.heights.min, seen.heights.max});
  if (where) text += ", within " + to_string(*where);
  context.warn(text + "; there the search is bounded by what lies beside");
}

}  // namespace

std::string why_impossible(const SurfaceRequest& request, const SatelliteImage& base,
                           const SatelliteImage& match) {
  const std::string both = base.file + " and " + match.file;
  if (!overlap(base, match)) return both + ": do not show the same ground; name images that do";
  if (!stand_apart(base, match)) {
    return both +
           ": were taken from the same place, so that no height can be seen; is one image "
           "given twice?";
  }
  const cv::Rect window = window_of(request, base);
  if (window.empty()) return outside(request, base);
  if (request.dem != nullptr && dem_coverage(base, window, *request.dem).share == 0) {
    return "the DEM does not cover what " + base.file + " shows; give one that does, or none";
  }
  return {};
}

void keep_possible(const SurfaceRequest& request, std::vector<PairChoice>& pairs,
                   const Context& context) {
  const std::vector<SatelliteImage>& images = request.images;
  std::vector<std::string> reasons;
  std::erase_if(pairs, [&](const PairChoice& pair) {
    const std::string why = why_impossible(request, images[pair.base], images[pair.match]);
    if (!why.empty()) reasons.push_back(why);
    return !why.empty();
  });
  if (pairs.empty()) {
    throw UsageError(reasons.empty() ? "no two of the images are fit to be matched; see 'pairs'"
                                     : reasons.front());
  }
  for (const std::string& why : reasons) context.warn(why + "; this pair is not matched");
  if (request.dem == nullptr) return;
  for (const PairChoice& pair : pairs) {
    const SatelliteImage& base = images[pair.base];
    warn_of_gaps(base, window_of(request, base), *request.dem, context);
  }
}

}  // namespace xgm::geo
