// SPDX-License-Identifier: Apache-2.0
// Pipelines on generated scenes, judged by the true surface.
#include <algorithm>
#include <cmath>

#include "geo/generated.hpp"
#include "geo/search.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/evaluation/surface_errors.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/geo/registry.hpp"
#include "xgm/geo/stage/range_prior.hpp"
#include "xgm/geo/stage/rectification.hpp"
#include "xgm/geo/stage/surface_family.hpp"
#include "xgm/pipeline/lookup.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::image_of;
using xgm::testing::search_volume;
using xgm::testing::searched_per_pixel;
using xgm::testing::TemporaryFolder;
using xgm::testing::truth_searched;

namespace {

/// The true surface where all images show the place, occluded or not; or only what all see.
cv::Mat1f judged(const SatelliteScene& scene, bool only_visible) {
  cv::Mat1f truth = scene.surface.values.clone();
  const CrsTransform to_ecef(with_heights(scene.surface.crs, "ellipsoid"), "EPSG:4978");
  for (std::size_t i = 0; i < scene.views.size(); ++i) {
    const cv::Rect2d shown({}, cv::Size2d(scene.spec.size - 1, scene.spec.size - 1));
    for (int row = 0; row < truth.rows; ++row) {
      for (int column = 0; column < truth.cols; ++column) {
        if (std::isnan(truth(row, column))) continue;
        const cv::Point2d centre = scene.surface.place.centre(column, row);
        const auto pixel = scene.views[i].truth.project(
            to_ecef.forward({centre.x, centre.y, double{truth(row, column)}}));
        const bool seen = pixel && shown.contains(*pixel) &&
                          (!only_visible || scene.visible[i](row, column) == 255);
        if (!seen) truth(row, column) = NAN;
      }
    }
  }
  return truth;
}

SatelliteSceneSpec mountains_and_flats() {
  SatelliteSceneSpec spec;
  spec.seed = 4;
  spec.size = 800;
  spec.gsd = spec.posting = 1;
  spec.relief = 300;
  spec.views = {{.azimuth = 12, .incidence = 10, .heading = 188, .pointing_error = {}},
                {.azimuth = 195, .incidence = 12, .heading = 193, .pointing_error = {}}};
  return spec;
}

struct Prior {
  RectifiedPair pair;
  DisparityRange range;
};

Prior run_prior(const std::string& name, const SatelliteImage& base, const SatelliteImage& match,
                const HeightField& dem) {
  Registry registry;
  add_geo(registry);
  const auto prior = make_stage<RangePrior>(name, registry);
  const cv::Rect window({}, base.size);
  RectifiedPair pair{base, match, {}, nullptr};
  pair.heights = prior->heights(base, match, window, &dem, Context());
  pair.geometry =
      make_stage<Rectifier>("affine", registry)->run(base, match, window, pair.heights, Context());
  return {pair, prior->run(pair, {&dem, nullptr}, Context())};
}

}  // namespace

TEST_CASE("the shipped pipelines find the true surface of a generated pair") {
  SatelliteSceneSpec spec;
  spec.size = 600;
  spec.relief = 80;
  spec.views = {{.azimuth = 12, .incidence = 7, .heading = 188, .pointing_error = {}},
                {.azimuth = 195, .incidence = 9, .heading = 193, .pointing_error = {0, 0.9}}};
  const SatelliteScene scene = make_satellite_scene(spec);
  const TemporaryFolder folder;
  SurfaceRequest request;
  request.images = xgm::testing::written_images(folder / "scene", scene);
  request.dem = read_dem(folder / "scene/dem.tif");
  Registry registry = Registry::with_builtins();
  add_geo(registry);
  for (const std::string name : {"dsm_tsgm8", "dsm_tmgm16_refined"}) {
    const Pipeline pipeline = require_pipeline(name, registry);
    const auto& family = dynamic_cast<const SurfaceFamily&>(pipeline.family());
    const SurfaceResult result = family.run(request, Context());
    for (const bool only_visible : {false, true}) {
      Raster truth = scene.surface;
      truth.values = judged(scene, only_visible);
      const SurfaceErrors errors =
          compare_surfaces(on_grid_of(result.fused.heights, truth), truth.values);
      MESSAGE(name << std::string(only_visible ? ", visible cells: " : ", all cells: ")
                   << errors.truth_cells << ", completeness " << errors.completeness
                   << ", coverage " << errors.coverage << ", median |dz| " << errors.median_error
                   << " m, signed " << errors.signed_median << " m, RMSE " << errors.rmse << " m");
      CHECK(errors.completeness > 0.7);
      CHECK(errors.median_error < 0.25);
      CHECK(std::abs(errors.signed_median) < 0.1);
    }
  }
}

TEST_CASE("a sculpted range holds the truth, in at most half of what the whole DEM searches") {
  const SatelliteScene scene = make_satellite_scene(mountains_and_flats());
  const Dem dem(scene.dem, "dem");
  const SatelliteImage base = image_of(scene.views[0].exact, scene.spec.size);
  const SatelliteImage match = image_of(scene.views[1].exact, scene.spec.size);
  const Prior sculpted = run_prior("dem_sculpting", base, match, dem);
  const Prior global = run_prior("dem_global", base, match, dem);
  const Prior cameras = run_prior("rpc_heights", base, match, dem);
  MESSAGE("disparities per pixel: sculpted " << searched_per_pixel(sculpted.range) << ", whole DEM "
                                             << searched_per_pixel(global.range)
                                             << ", cameras' heights "
                                             << searched_per_pixel(cameras.range));
  const auto inside = [&](const Prior& prior) {
    return truth_searched(prior.pair, prior.range, scene.heights[0]);
  };
  MESSAGE("truth inside: sculpted " << inside(sculpted) << ", whole DEM " << inside(global));
  CHECK(search_volume(sculpted.range) <= search_volume(global.range) / 2);
  CHECK(inside(sculpted) >= 0.995);
}
