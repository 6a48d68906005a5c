// SPDX-License-Identifier: Apache-2.0
// Disparities that a true surface says, beside what the generated images show.
#include "geo/cameras.hpp"
#include "geo/generated.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/evaluation/true_disparities.hpp"
#include "xgm/geo/stage/rectification.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::error_of;
using xgm::testing::geo_stage;
using xgm::testing::image_of;

namespace {

struct Generated {
  Generated() {
    SatelliteSceneSpec spec;
    spec.size = 300;
    spec.relief = 50;
    spec.views = {{.azimuth = 12, .incidence = 12, .heading = 188, .pointing_error = {}},
                  {.azimuth = 195, .incidence = 15, .heading = 193, .pointing_error = {}}};
    scene = make_satellite_scene(spec);
    pair.base = image_of(scene.views[0].exact, spec.size);
    pair.match = image_of(scene.views[1].exact, spec.size);
    pair.heights = scene.ground;
    pair.geometry = geo_stage<Rectifier>("affine")->run(
        pair.base, pair.match, cv::Rect(0, 0, spec.size, spec.size), pair.heights, Context());
  }
  SatelliteScene scene;
  RectifiedPair pair{image_with_nothing(), image_with_nothing(), {}, nullptr};

 private:
  static SatelliteImage image_with_nothing() {
    return image_of(xgm::testing::curved_pair().first.camera.model(), 1);
  }
};

}  // namespace

TEST_CASE("the true disparity of a pixel is that of the point which the pushbroom saw in it") {
  const Generated g;
  const TrueDisparities truth(g.scene.surface);
  int compared = 0, beside_edges = 0;
  double worst = 0;
  for (int k = 0; k < 2000; ++k) {
    const cv::Point pixel(k * 67 % 300, k * 131 % 300);
    const auto sight = truth.at(g.pair, g.pair.geometry->from_base(pixel));
    REQUIRE(sight);
    const auto point = g.pair.base.camera.localize(pixel, double{g.scene.heights[0](pixel)});
    const double error = std::abs(g.pair.see(*point)[2] - sight->disparity);
    ++compared;
    // RPC and pushbroom differ by up to 0.01 px, which at edges is another height.
    if (error > 0.05)
      ++beside_edges;
    else
      worst = std::max(worst, error);
  }
  MESSAGE(compared << " pixels, " << beside_edges << " beside edges, farthest " << worst << " px");
  CHECK(beside_edges < compared / 50);
  CHECK(worst < 0.03);
}

TEST_CASE("what the generated images both show is visible, what stands behind something is not") {
  const Generated g;
  const TrueDisparities truth(g.scene.surface);
  const CrsTransform to_wgs84(with_heights(g.scene.surface.crs, "ellipsoid"), std::string(kWgs84));
  int seen = 0, hidden = 0, wrong = 0;
  for (int k = 0; k < 60000; ++k) {
    const int row = k * 71 % g.scene.surface.values.rows;
    const int column = k * 113 % g.scene.surface.values.cols;
    if (g.scene.visible[0](row, column) != 255 || g.scene.visible[1](row, column) == 0) continue;
    const cv::Point2d centre = g.scene.surface.place.centre(column, row);
    const cv::Vec3d p =
        to_wgs84.forward({centre.x, centre.y, double{g.scene.surface.values(row, column)}});
    const cv::Point2d pixel = g.pair.base.camera.project({p[0], p[1], p[2]});
    const auto sight = truth.at(g.pair, g.pair.geometry->from_base(pixel));
    if (!sight) continue;
    const bool is_visible = g.scene.visible[1](row, column) == 255;
    (is_visible ? seen : hidden) += 1;
    wrong += sight->visible != is_visible ? 1 : 0;
  }
  MESSAGE(seen << " seen by both, " << hidden << " hidden, " << wrong << " judged otherwise");
  CHECK(seen > 1000);
  CHECK(hidden > 20);
  CHECK(wrong < (seen + hidden) / 50);  // edges
}

TEST_CASE(
    "a map is judged by true disparities: what is right, off by 3 px and missing is counted") {
  const Generated g;
  DisparityMap map(g.pair.geometry->size(), Status::ambiguous);
  const TrueDisparities truth(g.scene.surface);
  for (int y = 0; y < map.size().height; y += 2) {
    for (int x = 0; x < map.size().width; x += 2) {
      const auto sight = truth.at(g.pair, cv::Point2d(x, y));
      if (!sight || y % 4 == 0) continue;
      map.set(y, x, static_cast<float>(sight->disparity) + (x % 4 == 0 ? 3.0F : 0.0F));
    }
  }
  DisparityJudge judge(g.scene.surface);
  judge.add(g.pair, map);
  const auto regions = judge.evaluate();
  REQUIRE(regions.size() == 2);
  CHECK(regions[0].region == "all");
  const Evaluation& all = regions[0].evaluation;
  CHECK(all.invalid == doctest::Approx(0.5).epsilon(0.02));
  CHECK(all.average_error == doctest::Approx(1.5).epsilon(0.02));
  CHECK(all.at[1].bad == doctest::Approx(0.25).epsilon(0.02));
  CHECK(regions[1].evaluation.judged < all.judged);
}

TEST_CASE("a surface that does not say what its heights are counted from gives no disparities") {
  Raster surface{cv::Mat1f(5, 5, 10.0F), {500000, 5000000, 1, -1}, "EPSG:32632", {}};
  CHECK(xgm::testing::contains(error_of([&] { TrueDisparities truth(surface); }),
                               "does not say that its heights are above the ellipsoid"));
}
