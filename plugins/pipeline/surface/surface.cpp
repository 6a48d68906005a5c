// SPDX-License-Identifier: Apache-2.0
// The top of a file with `type: surface`: from satellite images to heights on a grid.
#include "plugins/pipeline/surface/cloud.hpp"
#include "plugins/pipeline/surface/grid.hpp"
#include "plugins/pipeline/surface/layers.hpp"
#include "plugins/pipeline/surface/match_pairs.hpp"
#include "plugins/pipeline/surface/possible.hpp"
#include "plugins/pipeline/surface/reasons.hpp"
#include "plugins/pipeline/surface/stages.hpp"
#include "xgm/geo/stage/surface_family.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class SurfacePipeline final : public SurfaceFamily {
 public:
  using Parameters = SurfaceStages;

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
    set.rule(
        {"filters", "matching"},
        "holds one that needs a confidence, which the maps do not have; give the matching "
        "part one (confidence of semi_global or left_right)",
        [&p] { return p.matching->gives_confidence() || !xgm::any_needs_confidence(p.filters); });
  }

  explicit SurfacePipeline(Parameters parameters) : p_(std::move(parameters)) {}

  SurfaceResult run(const SurfaceRequest& request, const Context& context) const override {
    SurfaceResult result;
    point(request, context, result);
    MatchedPairs matched = match_pairs(p_, p_.range_prior, request, result.images, result.pairs,
                                       context.part(0.15, 0.85));
    result.clouds = std::move(matched.clouds);
    const Crs crs = choose_crs(request.area, result.clouds);
    const CrsTransform to_grid("EPSG:4326", crs);
    for (PointCloud& cloud : result.clouds) move_to_grid(cloud, to_grid);
    const double step = p_.resolution > 0 ? p_.resolution : ground_pixel(request.images.front());
    result.grid = choose_grid(request.area, crs, result.clouds, step);
    make_surfaces(context.part(0.85, 1), request.outline, result);
    result.reasons =
        explain_cells(result.grid, result.fused.heights.values, result.surfaces, matched.seen);
    mark_outside(request.outline, result.grid, result.reasons);
    return result;
  }

  WorkAhead look_ahead(const SurfaceRequest& request, const Context& context) const override {
    SurfaceResult pointed;
    point(request, context, pointed);
    WorkAhead ahead =
        geo::look_ahead(p_, request, pointed.images, pointed.pairs, context.part(0.15, 0.85));
    ahead.pairs = pointed.pairs.size();
    const double step = p_.resolution > 0 ? p_.resolution : ground_pixel(request.images.front());
    ahead.surface_cells = cells_shown(request, pointed.images[pointed.pairs.front().base], step);
    return ahead;
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
  /// Chooses the pairs and corrects the cameras.
  void point(const SurfaceRequest& request, const Context& context, SurfaceResult& result) const {
    if (request.images.size() < 2) throw UsageError("give at least two satellite images");
    require_dem(request);
    result.pairs = p_.pairs(context.part(0, 0.01), request.images);
    keep_possible(request, result.pairs, context);
    const HeightInterval heights =
        common_heights(request.images.front().camera, request.images.back().camera);
    result.images = p_.pointing(context.part(0.01, 0.15), request.images, result.pairs,
                                GroundKnowledge{request.dem.get(), heights});
  }

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
