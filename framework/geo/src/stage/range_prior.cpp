// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/stage/range_prior.hpp"

#include <algorithm>
#include <cmath>

namespace xgm::geo {

std::optional<Interval> disparities_between(const RectifiedPair& pair, cv::Point2d rectified,
                                            const HeightInterval& heights) {
  const cv::Point2d pixel = pair.geometry->to_base(rectified);
  const auto low = pair.base.camera.localize(pixel, heights.min);
  const auto high = pair.base.camera.localize(pixel, heights.max);
  if (!low || !high) return std::nullopt;
  const double a = pair.see(*low)[2], b = pair.see(*high)[2];
  if (!std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
  return Interval{static_cast<int>(std::floor(std::min(a, b))),
                  static_cast<int>(std::ceil(std::max(a, b))) + 1};
}

const Slot<RangePrior>* RangePrior::coarse_prior(const SatelliteImage&, const SatelliteImage&,
                                                 const HeightInterval&, const HeightField*) const {
  return nullptr;
}

DisparityRange RangePrior::run(const RectifiedPair& pair, const KnownSurfaces&,
                               const Context&) const {
  constexpr int kSteps = 8;  // per direction; in between the range is all but linear
  const cv::Size size = pair.geometry->size();
  Interval hull;
  for (int k = 0; k < (kSteps + 1) * (kSteps + 1); ++k) {
    const cv::Point2d place((size.width - 1.0) * (k % (kSteps + 1)) / kSteps,
                            (size.height - 1.0) * (k / (kSteps + 1)) / kSteps);
    if (const auto range = disparities_between(pair, place, pair.heights)) {
      hull = unite(hull, *range);
    }
  }
  if (hull.empty()) throw Error(pair.base.file + ": its camera reaches no ground in this window");
  return DisparityRange::uniform(size, hull);
}

double parallax(const SatelliteImage& base, const SatelliteImage& match,
                const HeightInterval& heights) {
  const cv::Point2d middle(base.size.width / 2.0, base.size.height / 2.0);
  const auto low = base.camera.localize(middle, heights.min);
  const auto high = base.camera.localize(middle, heights.max);
  if (!low || !high) return 0;
  return cv::norm(match.camera.project(*high) - match.camera.project(*low));
}

DemCoverage dem_coverage(const SatelliteImage& image, const cv::Rect& window,
                         const HeightField& dem) {
  // In pixels: finer than the postings of global DEMs.
  const int step = std::max(16, std::max(window.width, window.height) / 256);
  DemCoverage seen{{INFINITY, -INFINITY}, 0, {}};
  int pixels = 0;
  for (int y = window.y; y < window.br().y + step - 1; y += step) {
    for (int x = window.x; x < window.br().x + step - 1; x += step) {
      const cv::Point pixel(std::min(x, window.br().x - 1), std::min(y, window.br().y - 1));
      const auto point = image.camera.localize(cv::Point2d(pixel), dem);
      ++pixels;
      if (!point) {
        seen.gaps.push_back(pixel);
        continue;
      }
      seen.heights = {std::min(seen.heights.min, point->height),
                      std::max(seen.heights.max, point->height)};
    }
  }
  if (pixels > 0) seen.share = 1 - static_cast<double>(seen.gaps.size()) / pixels;
  return seen;
}

HeightInterval dem_heights(const SatelliteImage& image, const cv::Rect& window,
                           const HeightField& dem) {
  const DemCoverage seen = dem_coverage(image, window, dem);
  if (seen.share == 0) throw Error("the DEM does not cover what " + image.file + " shows");
  return seen.heights;
}

}  // namespace xgm::geo
