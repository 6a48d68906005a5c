// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/surface/coarse.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/pipeline/surface/cloud.hpp"
#include "plugins/pipeline/surface/grid.hpp"
#include "plugins/pipeline/surface/match_pairs.hpp"

namespace xgm::geo {
namespace {

constexpr int kReduction = 4;
constexpr int kAround = 128;  // px of the images themselves; windows have a collar of 64

/// The area and what lies `around` m beside it.
DegreeBox grown(const DegreeBox& box, double around) {
  constexpr double kMetresPerDegree = 111e3;  // of latitude
  const double latitude = around / kMetresPerDegree;
  const double farthest = std::max(std::abs(box[1]), std::abs(box[3])) * CV_PI / 180;
  const double longitude = latitude / std::max(std::cos(farthest), 0.01);
  return {box[0] - longitude, box[1] - latitude, box[2] + longitude, box[3] + latitude};
}

SurfaceRequest coarse_request(const SurfaceRequest& request,
                              const std::vector<SatelliteImage>& images) {
  SurfaceRequest coarse{.images = {}, .dem = request.dem};
  for (const SatelliteImage& image : images) coarse.images.push_back(reduced(image, kReduction));
  if (request.area) coarse.area = grown(*request.area, kAround * ground_pixel(images.front()));
  if (!request.window.empty()) {
    const cv::Rect& window = request.window;
    const cv::Point low = (window.tl() - cv::Point(kAround, kAround)) / kReduction;
    const cv::Point high = (window.br() + cv::Point(kAround, kAround)) / kReduction;
    coarse.window =
        cv::Rect(low, high + cv::Point(1, 1)) & cv::Rect({}, coarse.images.front().size);
  }
  return coarse;
}

}  // namespace

Raster coarse_surface(const SurfaceStages& stages, const Slot<RangePrior>& prior,
                      const SurfaceRequest& request, const std::vector<SatelliteImage>& images,
                      const std::vector<PairChoice>& pairs, const Context& context) {
  const Context here = context.level("coarse", kReduction);
  const SurfaceRequest coarse = coarse_request(request, images);
  std::vector<PointCloud> clouds =
      match_pairs(stages, prior, coarse, coarse.images, pairs, here.part(0, 0.9)).clouds;
  std::erase_if(clouds, [](const PointCloud& cloud) { return cloud.points.empty(); });
  if (clouds.empty()) {
    here.warn(
        "nothing could be matched at a quarter of the resolution; the search is not "
        "narrowed");
    return {};
  }
  const Crs crs = choose_crs(coarse.area, clouds);
  const CrsTransform to_grid("EPSG:4326", crs);
  for (PointCloud& cloud : clouds) move_to_grid(cloud, to_grid);
  const GridSpec grid = choose_grid(coarse.area, crs, clouds, ground_pixel(coarse.images.front()));
  std::vector<Raster> surfaces;
  for (const PointCloud& cloud : clouds) {
    surfaces.push_back(
        stages.surface(here.scope(cloud.base + "_" + cloud.match), cloud.points, grid));
  }
  return stages.fusion(here, surfaces).heights;
}

}  // namespace xgm::geo
