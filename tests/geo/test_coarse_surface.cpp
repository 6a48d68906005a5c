// SPDX-License-Identifier: Apache-2.0
// Range priors where there is no DEM: a run at a quarter of the resolution, and when it is made.
#include <algorithm>
#include <cmath>

#include "geo/generated.hpp"
#include "geo/search.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/geo/registry.hpp"
#include "xgm/geo/stage/range_prior.hpp"
#include "xgm/geo/stage/rectification.hpp"
#include "xgm/geo/stage/surface_family.hpp"
#include "xgm/pipeline/lookup.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::image_of;
using xgm::testing::searched_per_pixel;
using xgm::testing::TemporaryFolder;
using xgm::testing::truth_searched;
using xgm::testing::written_images;

namespace {

const Registry& with_geo() {
  static const Registry registry = [] {
    Registry made = Registry::with_builtins();
    add_geo(made);
    return made;
  }();
  return registry;
}

SatelliteSceneSpec mountains(int size) {
  SatelliteSceneSpec spec;
  spec.seed = 4;
  spec.size = size;
  spec.gsd = spec.posting = 1;
  spec.relief = 300;
  spec.views = {{.azimuth = 12, .incidence = 10, .heading = 188, .pointing_error = {}},
                {.azimuth = 195, .incidence = 12, .heading = 193, .pointing_error = {}}};
  return spec;
}

/// What the range priors of a run gave, of the run itself and of those inside.
class Priors final : public Observer {
 public:
  void stage_end(const StagePlace& place, const StageStatistics&, const Artifact& result) override {
    const auto* const held = std::get_if<const DisparityRange*>(&result);
    if (place.kind != RangePrior::kKind || held == nullptr) return;
    plugins.push_back(place.plugin);
    if (place.level.scale == 1 && place.depth == 0) ranges.push_back(**held);
    if (place.level.scale > 1) coarse.push_back(**held);
  }
  void figure(const StagePlace& place, const std::string& name, double value) override {
    if (place.level.scale == 1) figures[name] = value;
  }
  bool ran(const std::string& plugin) const { return std::ranges::count(plugins, plugin) > 0; }

  std::vector<std::string> plugins;
  std::vector<DisparityRange> ranges, coarse;
  std::map<std::string, double> figures;
};

struct Run {
  SurfaceResult result;
  Priors priors;
  std::vector<RectifiedPair> pairs;
};

void run_surface(Run& run, SurfaceRequest request, const std::string& prior, int threads = 0) {
  request.matched = [&](const RectifiedPair& pair, const DisparityMap&) {
    run.pairs.push_back(pair);
  };
  const Pipeline pipeline =
      require_pipeline("dsm_tsgm8", with_geo(), {{"range_prior", prior}, {"filters", "[]"}});
  const auto& family = dynamic_cast<const SurfaceFamily&>(pipeline.family());
  pipeline.in_run({.observer = &run.priors, .threads = threads},
                  [&](const Context& context) { run.result = family.run(request, context); });
}

bool identical(const cv::Mat1f& a, const cv::Mat1f& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) {
           return x == y || (std::isnan(x) && std::isnan(y));
         });
}

RectifiedPair plain_pair(double height) {
  SatelliteSceneSpec spec;
  spec.size = 400;
  spec.gsd = 1;
  spec.rpc_below = spec.rpc_above = 400;
  const SatelliteCameras cameras = make_satellite_cameras(spec);
  RectifiedPair pair{image_of(cameras.views[0].exact, spec.size),
                     image_of(cameras.views[1].exact, spec.size),
                     {height - 150, height + 250},
                     nullptr};
  pair.geometry =
      make_stage<Rectifier>("affine", with_geo())
          ->run(pair.base, pair.match, cv::Rect({}, pair.base.size), pair.heights, Context());
  return pair;
}

/// A pair without pixels above ground of `height`, and a coarse surface of that height with cells
/// of 4 m.
struct Plain {
  explicit Plain(double height) : pair(plain_pair(height)) {
    const auto middle = *pair.base.camera.localize({200, 200}, height);
    coarse.crs = utm_crs(middle.longitude, middle.latitude);
    const cv::Vec3d place =
        CrsTransform("EPSG:4326", coarse.crs).forward({middle.longitude, middle.latitude, 0});
    constexpr int kCells = 200;
    coarse.place = {place[0] - 2 * kCells, place[1] + 2 * kCells, 4, -4};
    coarse.values = cv::Mat1f(kCells, kCells, static_cast<float>(height));
  }

  DisparityRange range(const std::string& yaml = "coarse_surface") const {
    return make_stage<RangePrior>(yaml, with_geo())->run(pair, {nullptr, &coarse}, Context());
  }
  HeightInterval whole() const { return common_heights(pair.base.camera, pair.match.camera); }
  /// The cell that a pixel of the rectified image shows at a height.
  cv::Point cell(cv::Point pixel, double height) const {
    const auto point =
        *pair.base.camera.localize(pair.geometry->to_base(cv::Point2d(pixel)), height);
    const cv::Vec3d place =
        CrsTransform("EPSG:4326", coarse.crs).forward({point.longitude, point.latitude, 0});
    const cv::Point2d cell = coarse.place.cell({place[0], place[1]});
    return {cvRound(cell.x), cvRound(cell.y)};
  }

  RectifiedPair pair;
  Raster coarse;
};

constexpr double kHeight = 430;

}  // namespace

TEST_CASE("around a plain the band is its height and the margin") {
  const Plain plain(kHeight);
  const DisparityRange range = plain.range("{type: coarse_surface, margin: 12, step: 1}");
  for (const cv::Point p : {cv::Point(150, 150), cv::Point(200, 210), cv::Point(250, 160)}) {
    const auto expected =
        disparities_between(plain.pair, cv::Point2d(p), {kHeight - 12, kHeight + 12});
    REQUIRE(expected);
    CHECK(range.at(p.y, p.x) == *expected);
  }
}

TEST_CASE("in holes all heights of the cameras are searched; small holes are closed") {
  Plain plain(kHeight);
  const cv::Point hole(150, 150), gap(250, 250), clear(200, 150);
  const cv::Point far = plain.cell(hole, kHeight), near = plain.cell(gap, kHeight);
  plain.coarse.values(cv::Rect(far - cv::Point(9, 9), cv::Size(19, 19))).setTo(NAN);
  plain.coarse.values(cv::Rect(near - cv::Point(1, 1), cv::Size(3, 3))).setTo(NAN);
  const DisparityRange range = plain.range();
  const auto all = [&](cv::Point p) {
    return *disparities_between(plain.pair, cv::Point2d(p), plain.whole());
  };
  CHECK(range.at(hole.y, hole.x).size() >= all(hole).size() - 1);
  CHECK(range.at(hole.y, hole.x).size() <= all(hole).size() + 1);
  CHECK(range.at(gap.y, gap.x).size() < all(gap).size() / 5);
  CHECK(range.at(clear.y, clear.x).size() < all(clear).size() / 5);
  const DisparityRange open = plain.range("{type: coarse_surface, reach: 0}");
  CHECK(open.at(gap.y, gap.x).size() >= all(gap).size() - 1);
}

TEST_CASE("without a cell, or far from all of them, all heights of the cameras are searched") {
  Plain plain(kHeight);
  plain.pair.heights = plain.whole();
  const double all = searched_per_pixel(
      make_stage<RangePrior>("rpc_heights", with_geo())->run(plain.pair, {}, Context()));
  plain.coarse.place.left += 1e5;
  CHECK(searched_per_pixel(plain.range()) > 0.9 * all);
  plain.coarse.values = NAN;
  CHECK(searched_per_pixel(plain.range()) > 0.9 * all);
  plain.coarse = {};
  CHECK(searched_per_pixel(plain.range()) > 0.9 * all);
  CHECK(contains(
      error_of([&] {
        make_stage<RangePrior>("coarse_surface", with_geo())->run(plain.pair, {}, Context());
      }),
      "quarter of the resolution"));
}

TEST_CASE("beside an edge the band holds both of its sides, as far as it reaches") {
  Plain plain(kHeight);
  const cv::Point pixel(200, 200);
  const cv::Point cell = plain.cell(pixel, kHeight);
  plain.coarse.values.colRange(cell.x + 2, plain.coarse.values.cols)
      .setTo(static_cast<float>(kHeight - 60));
  const auto width = [&](const std::string& reach) {
    const std::string yaml = "{type: coarse_surface, step: 1, margin: 5, reach: " + reach + "}";
    return plain.range(yaml).at(pixel.y, pixel.x).size();
  };
  const int both =
      disparities_between(plain.pair, cv::Point2d(pixel), {kHeight - 65, kHeight + 5})->size();
  CHECK(width("0") < both / 3);
  CHECK(width("3") >= both - 1);
}

TEST_CASE("coarse_surface holds the truth in a fraction of the search, the same on all threads") {
  const SatelliteScene scene = make_satellite_scene(mountains(800));
  const TemporaryFolder folder;
  SurfaceRequest request;
  request.images = written_images(folder / "scene", scene);
  Run one, two;
  run_surface(one, request, "coarse_surface", 1);
  run_surface(two, request, "coarse_surface", 2);
  REQUIRE(one.priors.ranges.size() == 1);
  REQUIRE(one.priors.coarse.size() == 1);
  const DisparityRange& range = one.priors.ranges[0];
  const double all = searched_per_pixel(
      make_stage<RangePrior>("rpc_heights", with_geo())
          ->run({one.pairs[0].base, one.pairs[0].match,
                 common_heights(one.pairs[0].base.camera, one.pairs[0].match.camera),
                 one.pairs[0].geometry},
                {}, Context()));
  const double inside = truth_searched(one.pairs[0], range, scene.heights[0]);
  MESSAGE("disparities per pixel: " << searched_per_pixel(range) << ", cameras' heights " << all
                                    << ", coarse run " << searched_per_pixel(one.priors.coarse[0])
                                    << "; truth inside " << inside << "; not known "
                                    << one.priors.figures["unknown_share"]);
  CHECK(inside >= 0.995);
  CHECK(searched_per_pixel(range) < all / 2);
  CHECK(one.priors.figures["searched_px"] == doctest::Approx(searched_per_pixel(range)));
  CHECK(one.priors.figures["searched_m"] > 50);  // twice the margin
  CHECK(identical(one.result.fused.heights.values, two.result.fused.heights.values));
  REQUIRE(two.priors.ranges.size() == 1);
  const DisparityRange& other = two.priors.ranges[0];
  REQUIRE(range.size() == other.size());
  bool same = true;
  for (int y = 0; y < range.size().height; ++y) {
    for (int x = 0; x < range.size().width; ++x) same = same && range.at(y, x) == other.at(y, x);
  }
  CHECK(same);
}

TEST_CASE("coarse_surface: areas, windows and tiles have a surface up to their borders") {
  const SatelliteScene scene = make_satellite_scene(mountains(500));
  const TemporaryFolder folder;
  SurfaceRequest request;
  request.images = written_images(folder / "scene", scene);
  request.window = {150, 140, 220, 210};
  Run run;
  run_surface(run, request, "coarse_surface");
  MESSAGE("not known within a window: " << run.priors.figures["unknown_share"]);
  CHECK(run.priors.figures["unknown_share"] < 0.1);
  CHECK(run.priors.coarse[0].size().width < 220);
  CHECK(run.result.grid.size.width < 400);
}

TEST_CASE("auto: a DEM, else key points, else, in large images with a wide search, a coarser run") {
  const SatelliteScene scene = make_satellite_scene(mountains(400));
  const TemporaryFolder folder;
  SurfaceRequest request;
  request.images = written_images(folder / "scene", scene);
  const auto ran = [&](const std::string& prior, const std::string& plugin) {
    Run run;
    run_surface(run, request, prior);
    REQUIRE(run.priors.ran("auto"));
    CHECK(run.priors.figures.contains("searched_px"));
    CHECK(run.priors.coarse.empty() == (plugin != "coarse_surface"));
    return run.priors.ran(plugin);
  };
  CHECK(ran("auto", "keypoints"));  // small images
  CHECK(ran("{type: auto, large_side: 400, wide_search: 5}", "coarse_surface"));
  CHECK(ran("{type: auto, large_side: 400, wide_search: 5000}", "keypoints"));
  request.dem = read_dem(folder / "scene/dem.tif");
  CHECK(ran("{type: auto, large_side: 400, wide_search: 5}", "dem_sculpting"));
}
