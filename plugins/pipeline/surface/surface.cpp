// SPDX-License-Identifier: Apache-2.0
// The top of a file with `type: surface`: from satellite images to heights on a grid.
#include <algorithm>
#include <memory>

#include "plugins/pipeline/surface/cloud.hpp"
#include "plugins/pipeline/surface/grid.hpp"
#include "plugins/pipeline/surface/layers.hpp"
#include "plugins/pipeline/surface/possible.hpp"
#include "plugins/pipeline/surface/reasons.hpp"
#include "xgm/data/image_parts.hpp"
#include "xgm/geo/image/resample.hpp"
#include "xgm/geo/stage/pointing.hpp"
#include "xgm/geo/stage/range_prior.hpp"
#include "xgm/geo/stage/rectification.hpp"
#include "xgm/geo/stage/surface_family.hpp"
#include "xgm/geo/stage/triangulation.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class SurfacePipeline final : public SurfaceFamily {
 public:
  struct Parameters {
    Slot<Pairs> pairs;
    Slot<Pointing> pointing;
    Slot<Rectifier> rectification;
    Slot<RangePrior> range_prior;
    Slot<StereoFamily> matching;
    SlotList<Filter> filters;
    Slot<Triangulation> triangulation;
    Slot<Surface> surface;
    Slot<Fusion> fusion;
    double resolution = 0;
    int tile = 2000;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("pairs", p.pairs, "Which images are matched.").default_stage("all");
    set.add("pointing", p.pointing, "Corrects the cameras.").default_stage("keypoints");
    set.add("rectification", p.rectification, "Brings corresponding points into one row.")
        .default_stage("affine");
    set.add("range_prior", p.range_prior, "Bounds the search.").default_stage("auto");
    set.add("matching", p.matching, "The stereo pipeline that finds disparities.");
    set.add("filters", p.filters,
            "What is done to the disparities before triangulation, in order.");
    set.add("triangulation", p.triangulation, "Makes points of disparities.").default_stage("rays");
    set.add("surface", p.surface, "Makes a grid of points.").default_stage("median");
    set.add("fusion", p.fusion, "Makes one surface of those of the pairs.").default_stage("median");
    set.add("resolution", p.resolution,
            "Size of a cell of the surface; 0: that of a pixel of the first image on the ground.")
        .unit("m")
        .range(0, 1000);
    set.add("tile", p.tile, "Largest side of the windows that are rectified and matched at a time.")
        .unit("px")
        .range(100, 20000);
  }

  explicit SurfacePipeline(Parameters parameters) : p_(std::move(parameters)) {}

  SurfaceResult run(const SurfaceRequest& request, const Context& context) const override {
    if (request.images.size() < 2) throw UsageError("give at least two satellite images");
    require_dem(request);
    SurfaceResult result;
    result.pairs = p_.pairs(context.part(0, 0.01), request.images);
    keep_possible(request, result.pairs, context);
    const HeightInterval heights =
        common_heights(request.images.front().camera, request.images.back().camera);
    result.images = p_.pointing(context.part(0.01, 0.15), request.images, result.pairs,
                                GroundKnowledge{request.dem.get(), heights});
    std::vector<SeenPair> seen;
    for (std::size_t i = 0; i < result.pairs.size(); ++i) {
      const double n = static_cast<double>(result.pairs.size());
      const double begin = 0.15 + 0.7 * static_cast<double>(i) / n;
      seen.push_back(
          {result.images[result.pairs[i].base], result.images[result.pairs[i].match], {}});
      result.clouds.push_back(
          match_pair(request, seen.back(), context.part(begin, begin + 0.7 / n)));
    }
    const Crs crs = choose_crs(request.area, result.clouds);
    const CrsTransform to_grid("EPSG:4326", crs);
    for (PointCloud& cloud : result.clouds) move_to_grid(cloud, to_grid);
    const double step = p_.resolution > 0 ? p_.resolution : ground_pixel(request.images.front());
    result.grid = choose_grid(request.area, crs, result.clouds, step);
    make_surfaces(context.part(0.85, 1), request.outline, result);
    result.reasons = explain_cells(result.grid, result.fused.heights.values, result.surfaces, seen);
    mark_outside(request.outline, result.grid, result.reasons);
    return result;
  }

  SurfaceResult rasterise(CloudRequest request, const Context& context) const override {
    if (request.clouds.pairs.empty()) throw UsageError("the clouds hold no points");
    const double step = p_.resolution > 0 ? p_.resolution : request.clouds.resolution;
    if (step <= 0) {
      throw UsageError(
          "the clouds do not say the resolution of a surface; set it: --set resolution=0.5");
    }
    SurfaceResult result;
    result.clouds = std::move(request.clouds.pairs);
    result.grid = choose_grid(request.area, request.clouds.crs, result.clouds, step);
    make_surfaces(context, request.outline, result);
    return result;
  }

 private:
  void require_dem(const SurfaceRequest& request) const {
    if (request.dem != nullptr) return;
    for (const auto& [field, needed] : {std::pair{"range_prior", p_.range_prior->needs_dem()},
                                        std::pair{"pointing", p_.pointing->needs_dem()}}) {
      if (needed) {
        throw UsageError(std::string(field) +
                         ": needs heights that are known; give a DEM (--dem FILE), or choose "
                         "another plugin ('pipeline list " +
                         field + "')");
      }
    }
  }

  PointCloud match_pair(const SurfaceRequest& request, SeenPair& pair,
                        const Context& context) const {
    const Context here = context.scope(pair.base.name + "_" + pair.match.name);
    const GreyScale base_scale = find_grey_scale(pair.base),
                    match_scale = find_grey_scale(pair.match);
    const cv::Rect whole = window_of(request, pair.base);
    const std::vector<cv::Rect> windows = image_parts(whole.size(), {p_.tile, p_.tile});
    PointCloud cloud;
    cloud.base = pair.base.name;
    cloud.match = pair.match.name;
    for (std::size_t i = 0; i < windows.size(); ++i) {
      const double n = static_cast<double>(windows.size());
      const Context tile = here.part(static_cast<double>(i) / n, static_cast<double>(i + 1) / n);
      match_window(request, pair, windows[i] + whole.tl(), base_scale, match_scale,
                   windows.size() > 1 ? tile.scope("tile_" + std::to_string(i + 1)) : tile, cloud);
    }
    return cloud;
  }

  void match_window(const SurfaceRequest& request, SeenPair& seen, const cv::Rect& window,
                    const GreyScale& base_scale, const GreyScale& match_scale,
                    const Context& context, PointCloud& cloud) const {
    const HeightField* const dem = request.dem.get();
    RectifiedPair pair{seen.base, seen.match, {}, nullptr};
    pair.heights = p_.range_prior->heights(seen.base, seen.match, window, dem, context);
    // More than the window, so that what lies at its border is matched with what is around it.
    constexpr int kCollar = 64;  // px
    const cv::Rect around = cv::Rect(window.tl() - cv::Point(kCollar, kCollar),
                                     window.size() + cv::Size(2 * kCollar, 2 * kCollar)) &
                            cv::Rect({}, seen.base.size);
    pair.geometry = p_.rectification(context, seen.base, seen.match, around, pair.heights);
    DisparityRange range = p_.range_prior(context, pair, dem);
    const MatchRequest matching{resample(pair, base_scale, match_scale), std::move(range), {}};
    const DisparityMap map = matched(matching, context);
    if (request.matched) request.matched(pair, map);
    const PointGrid points = p_.triangulation(context, pair, map);
    append(cloud, points, map, matching.pair.base.planes.front(), *pair.geometry, window);
    seen.windows.push_back(remember(window, pair, matching, map, points));
  }

  DisparityMap matched(const MatchRequest& request, const Context& context) const {
    if (request.range.hull().empty()) return DisparityMap(request.pair.size());
    DisparityMap map = p_.matching(context, request).forward;
    for (const auto& filter : p_.filters) map = filter(context, map, request.pair);
    return map;
  }

  /// Of the clouds, on the grid.
  void make_surfaces(const Context& context, const Outline& outline, SurfaceResult& result) const {
    for (const PointCloud& cloud : result.clouds) {
      const Context here =
          context.scope(cloud.match.empty() ? cloud.base : cloud.base + "_" + cloud.match);
      result.surfaces.push_back(p_.surface(here, cloud.points, result.grid));
      clear_outside(outline, result.surfaces.back());
      if (result.surfaces.size() > 1) continue;
      result.orthoimage =
          p_.surface(here.scope("ortho"), with_values(cloud.points, cloud.greys), result.grid);
      clear_outside(outline, result.orthoimage);
    }
    result.fused = p_.fusion(context, result.surfaces);
    result.fused.heights.metadata["vertical_datum"] = kEllipsoidalHeights;
    add_layers(result);
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<SurfacePipeline>("surface",
                                "From satellite images with RPC cameras to a surface model.");
}
