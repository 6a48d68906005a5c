// SPDX-License-Identifier: Apache-2.0
// The surfaces of six generated pairs, one by one and fused.
#include <algorithm>
#include <cmath>

#include "geo/cameras.hpp"
#include "geo/generated.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/evaluation/surface_errors.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/geo/stage/surface_family.hpp"
#include "xgm/geo/synthesis/plan_views.hpp"
#include "xgm/pipeline/lookup.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::geo_stage;
using xgm::testing::TemporaryFolder;

namespace {

SatelliteScene four_images() {
  SatelliteSceneSpec spec;
  spec.seed = 7;
  spec.size = 400;
  spec.gsd = spec.posting = 0.7;
  spec.relief = 40;
  spec.dem_posting = 15;
  spec.views = plan_views({.images = 4, .dates = 4, .incidence = 11}, spec.seed);
  return make_satellite_scene(spec);
}

SurfaceResult run(const SatelliteScene& scene, const std::string& folder) {
  SurfaceRequest request;
  request.images = xgm::testing::written_images(folder, scene);
  request.dem = read_dem(folder + "/dem.tif");
  Registry registry = Registry::with_builtins();
  add_geo(registry);
  // Whole disparities are metres of height here.
  const Pipeline pipeline = require_pipeline(
      "dsm_tsgm8", registry, {{"matching.matcher.matcher.matcher.refinement", "parabola"}});
  return dynamic_cast<const SurfaceFamily&>(pipeline.family()).run(request, Context());
}

/// Where every image shows the place.
Raster truth_of(const SatelliteScene& scene) {
  Raster truth = scene.surface;
  for (const cv::Mat1b& visible : scene.visible) truth.values.setTo(NAN, visible == 0);
  return truth;
}

}  // namespace

TEST_CASE(
    "six fused pairs are more complete, and closer to the truth, than the most complete of them") {
  const SatelliteScene scene = four_images();
  const TemporaryFolder folder;
  const SurfaceResult result = run(scene, folder / "scene");
  REQUIRE(result.surfaces.size() == 6);
  const Raster truth = truth_of(scene);
  const cv::Mat1f fused = on_grid_of(result.fused.heights, truth);
  const SurfaceErrors whole = compare_surfaces(fused, truth.values);
  double most_complete = 0, ours = 0, theirs = 0;  // of the most complete pair
  for (const Raster& surface : result.surfaces) {
    const cv::Mat1f pair = on_grid_of(surface, truth);
    const SurfaceErrors errors = compare_surfaces(pair, truth.values);
    cv::Mat1f common = truth.values.clone();
    for (int y = 0; y < common.rows; ++y) {
      for (int x = 0; x < common.cols; ++x) {
        if (std::isnan(pair(y, x) + fused(y, x))) common(y, x) = NAN;
      }
    }
    const double rmse = compare_surfaces(pair, common).rmse;
    MESSAGE("pair: completeness " << errors.completeness << ", RMSE " << rmse << " m, fused there "
                                  << compare_surfaces(fused, common).rmse << " m");
    if (errors.completeness <= most_complete) continue;
    most_complete = errors.completeness;
    theirs = rmse;
    ours = compare_surfaces(fused, common).rmse;
  }
  MESSAGE("fused: completeness " << whole.completeness << ", RMSE " << whole.rmse << " m");
  CHECK(whole.completeness > most_complete);
  CHECK(ours < theirs);

  // The same surfaces, one of them raised by 3 m.
  std::vector<Raster> surfaces = result.surfaces;
  surfaces[2].values = surfaces[2].values + 3;
  const FusedSurface raised = geo_stage<Fusion>("median")->run(surfaces, Context());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    CAPTURE(i);
    const double planted = i == 2 ? 3 : 0;
    CHECK(std::abs(raised.offsets[i] - result.fused.offsets[i] - planted) < 0.3);
    CHECK(std::abs(raised.offsets[i] - planted) < 0.6);
  }
}
