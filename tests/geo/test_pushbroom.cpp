// SPDX-License-Identifier: Apache-2.0
// Cameras of generated scenes: a pushbroom on an orbit, and the RPCs fitted to it.
#include <algorithm>
#include <cmath>

#include "geo/generated.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/registry.hpp"
#include "xgm/geo/stage/rectification.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::image_of;

namespace {

SatelliteSceneSpec large() {
  SatelliteSceneSpec spec;
  spec.size = 10000;
  spec.relief = 800;
  spec.views = {{.azimuth = 15, .incidence = 12, .heading = 188, .pointing_error = {}},
                {.azimuth = 205, .incidence = 20, .heading = 194, .pointing_error = {}},
                {.azimuth = 100, .incidence = 30, .heading = 191, .pointing_error = {}}};
  return spec;
}

}  // namespace

TEST_CASE("a pushbroom sees a point in the pixel whose line of sight passes through it") {
  const SatelliteCameras cameras = make_satellite_cameras(large());
  for (const SatelliteSceneView& view : cameras.views) {
    for (const cv::Point2d pixel : {cv::Point2d(0, 0), cv::Point2d(9999, 12.25),
                                    cv::Point2d(4000.5, 9999), cv::Point2d(4999.5, 4999.5)}) {
      const Ray sight = view.truth.sight(pixel);
      for (const double distance : {690e3, 710e3}) {
        const auto seen = view.truth.project(sight.origin + distance * sight.direction);
        REQUIRE(seen);
        CHECK(cv::norm(*seen - pixel) < 1e-6);
      }
    }
  }
}

TEST_CASE("a pushbroom has the angles and the pixels that were asked for") {
  const SatelliteSceneSpec spec = large();
  const SatelliteCameras cameras = make_satellite_cameras(spec);
  for (std::size_t i = 0; i < spec.views.size(); ++i) {
    const RpcCamera rpc(cameras.views[i].exact);
    const cv::Point2d middle(4999.5, 4999.5);
    const auto angles = rpc.view_angles(middle);
    REQUIRE(angles);
    CHECK(angles->incidence == doctest::Approx(spec.views[i].incidence).epsilon(1e-3));
    CHECK(angles->azimuth == doctest::Approx(spec.views[i].azimuth).epsilon(1e-3));
    const double height = (cameras.ground.min + cameras.ground.max) / 2;
    const auto here = rpc.localize(middle, height);
    const auto below = rpc.localize(middle + cv::Point2d(0, 100), height);
    REQUIRE(here);
    REQUIRE(below);
    const cv::Vec3d step = local_axes(*here).t() * (to_ecef(*below) - to_ecef(*here)) * (1 / 100.0);
    const double heading = spec.views[i].heading * CV_PI / 180;
    CHECK(std::abs(step.dot(cv::normalize(cv::Vec3d(std::sin(heading), std::cos(heading), 0))) -
                   cv::norm(step)) < 2e-3);
    CHECK(cv::norm(step) >= 0.495);
  }
}

TEST_CASE("RPCs fit a pushbroom of 10,000 px to 0.01 px, also where it was not sampled") {
  const SatelliteCameras cameras = make_satellite_cameras(large());
  for (const SatelliteSceneView& view : cameras.views) {
    const RpcCamera rpc(view.exact);
    double worst = 0;
    for (int k = 0; k < 1000; ++k) {
      const cv::Point2d pixel(9999.0 * (k * 37 % 101) / 100, 9999.0 * (k * 53 % 97) / 96);
      const double share = (k * 29 % 83) / 82.0;
      const double height = cameras.ground.min + share * (cameras.ground.max - cameras.ground.min);
      const auto point = rpc.localize(pixel, height);
      REQUIRE(point);
      const auto seen = view.truth.project(to_ecef(*point));
      REQUIRE(seen);
      worst = std::max(worst, cv::norm(*seen - pixel));
    }
    MESSAGE("fit residual " << view.fit_residual << " px, at other points " << worst << " px");
    CHECK(view.fit_residual < 0.01);
    CHECK(worst < 0.01);
  }
}

TEST_CASE("a pushbroom is not affine: one affine rectification of 10,000 px leaves 0.2 px") {
  const SatelliteSceneSpec spec = large();
  const SatelliteCameras cameras = make_satellite_cameras(spec);
  Registry registry;
  add_geo(registry);
  const auto affine = make_stage<Rectifier>("affine", registry);
  const SatelliteImage base = image_of(cameras.views[0].exact, spec.size);
  for (std::size_t i = 1; i < cameras.views.size(); ++i) {
    const SatelliteImage match = image_of(cameras.views[i].exact, spec.size);
    const auto residual = [&](int side) {
      return affine->run(base, match, {0, 0, side, side}, cameras.ground, Context())->residual();
    };
    MESSAGE("affine rectification leaves " << residual(1000) << " px of 1000, " << residual(10000)
                                           << " px of 10000 px");
    CHECK(residual(10000) > 0.2);
    CHECK(residual(1000) < 0.1);
  }
}

TEST_CASE("a planted pointing error moves the RPC and nothing else") {
  SatelliteSceneSpec spec = large();
  spec.views[1].pointing_error = {1.5, -0.7};
  const SatelliteSceneView view = make_satellite_cameras(spec).views[1];
  const cv::Point2d moved(view.delivered.column.offset - view.exact.column.offset,
                          view.delivered.row.offset - view.exact.row.offset);
  CHECK(cv::norm(moved) == doctest::Approx(std::hypot(1.5, 0.7)));
  // Points of one line of sight of the first image move along the first component.
  const RpcCamera first(make_satellite_cameras(spec).views[0].exact), second(view.exact);
  const auto low = first.localize({4999.5, 4999.5}, 500),
             high = first.localize({4999.5, 4999.5}, 900);
  REQUIRE(low);
  REQUIRE(high);
  const cv::Point2d way = second.project(*high) - second.project(*low);
  CHECK(moved.dot(way) / cv::norm(way) == doctest::Approx(1.5).epsilon(1e-3));
}

TEST_CASE("mistakes in a satellite scene are named") {
  SatelliteSceneSpec spec;
  spec.views[1].incidence = 70;
  CHECK(contains(error_of([&] { make_satellite_cameras(spec); }), "incidence of view 2 is 70"));
  spec = {};
  spec.views.resize(1);
  CHECK(contains(error_of([&] { make_satellite_cameras(spec); }), "at least two views"));
  spec = {};
  spec.dem_datum = "sea";
  spec.size = 64;
  CHECK(contains(error_of([&] { make_satellite_scene(spec); }), "'sea' is no vertical datum"));
}
