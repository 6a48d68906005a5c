// SPDX-License-Identifier: Apache-2.0
// Generated images: they show the true surface through the true cameras.
#include <algorithm>
#include <cmath>
#include <vector>

#include "geo/generated.hpp"
#include "geo/photo_check.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

SatelliteSceneSpec small(int size) {
  SatelliteSceneSpec spec;
  spec.size = size;
  spec.relief = 60;
  spec.dem_posting = 10;
  spec.rpc_below = spec.rpc_above = 20;
  spec.views = {{.azimuth = 12, .incidence = 10, .heading = 188, .pointing_error = {}},
                {.azimuth = 195, .incidence = 14, .heading = 193, .pointing_error = {}}};
  return spec;
}

/// The surface as one reads it off four cells.
double surface_at(const Raster& surface, double x, double y) {
  const cv::Point2d cell = surface.place.cell({x, y});
  const int i = cvFloor(cell.x), j = cvFloor(cell.y);
  const double u = cell.x - i, v = cell.y - j;
  const cv::Mat1f& h = surface.values;
  return (1 - v) * ((1 - u) * double{h(j, i)} + u * double{h(j, i + 1)}) +
         v * ((1 - u) * double{h(j + 1, i)} + u * double{h(j + 1, i + 1)});
}

/// How far the surface rises above the line from a point to the satellite, at most, m.
double obstruction(const Raster& surface, const CrsTransform& to_map, const PushbroomCamera& camera,
                   const cv::Vec3d& ecef, double highest) {
  const cv::Vec3d up = -camera.sight(*camera.project(ecef)).direction;
  double worst = -INFINITY;
  for (double t = 0.3;; t += 0.1) {
    const cv::Vec3d p = to_map.forward(ecef + t * up);
    if (p[2] > highest) return worst;
    worst = std::max(worst, surface_at(surface, p[0], p[1]) - p[2]);
  }
}

}  // namespace

TEST_CASE("cells of the true surface are where the RPC and the pushbroom both see them") {
  const SatelliteScene scene = make_satellite_scene(small(256));
  const CrsTransform to_wgs84(scene.surface.crs, "EPSG:4326");
  for (const SatelliteSceneView& view : scene.views) {
    const RpcCamera rpc(view.exact);
    double worst = 0;
    for (int row = 0; row < scene.surface.values.rows; row += 7) {
      for (int column = 0; column < scene.surface.values.cols; column += 7) {
        const cv::Point2d centre = scene.surface.place.centre(column, row);
        const cv::Vec3d p = to_wgs84.forward({centre.x, centre.y, 0});
        const GeoPoint point{p[0], p[1], double{scene.surface.values(row, column)}};
        const cv::Point2d pixel = rpc.project(point);
        if (!cv::Rect2d(0, 0, 255, 255).contains(pixel)) continue;
        worst = std::max(worst, cv::norm(*view.truth.project(to_ecef(point)) - pixel));
      }
    }
    MESSAGE("farthest " << worst << " px, fit residual " << view.fit_residual << " px");
    CHECK(worst < 0.02);
  }
}

TEST_CASE("pixels show the first point of the surface that their line of sight meets") {
  const SatelliteScene scene = make_satellite_scene(small(200));
  const CrsTransform to_map("EPSG:4978", with_heights(scene.surface.crs, "ellipsoid"));
  const PushbroomCamera& camera = scene.views[1].truth;
  double worst = 0;
  int missed = 0, compared = 0;
  for (int k = 0; k < 300; ++k) {
    const cv::Point pixel(k * 67 % 200, k * 31 % 200);
    const Ray sight = camera.sight(pixel);
    // In small steps from above all objects.
    double t = 690e3, z = INFINITY;
    const auto clearance = [&](double distance) {
      const cv::Vec3d p = to_map.forward(sight.origin + distance * sight.direction);
      z = p[2];
      return p[2] > scene.ground.max ? 1.0 : p[2] - surface_at(scene.surface, p[0], p[1]);
    };
    while (to_map.forward(sight.origin + t * sight.direction)[2] > scene.ground.max + 20) t += 10;
    while (clearance(t) > 0) t += 0.05;
    double before = t - 0.05;
    for (int halving = 0; halving < 30; ++halving) {
      const double middle = (before + t) / 2;
      (clearance(middle) > 0 ? before : t) = middle;
    }
    clearance(t);
    const double error = std::abs(z - double{scene.heights[1](pixel)});
    ++compared;
    // A step of the naive search may pass through an edge.
    if (error > 0.2)
      ++missed;
    else
      worst = std::max(worst, error);
  }
  MESSAGE(compared << " pixels, " << missed << " beside edges, farthest " << 1000 * worst << " mm");
  CHECK(worst < 0.02);
  CHECK(missed <= 3);
}

TEST_CASE("cells are occluded where the surface stands before them") {
  const SatelliteScene scene = make_satellite_scene(small(200));
  const CrsTransform to_map("EPSG:4978", with_heights(scene.surface.crs, "ellipsoid"));
  const double highest =
      *std::max_element(scene.surface.values.begin(), scene.surface.values.end());
  int occluded = 0, wrong = 0, compared = 0;
  for (std::size_t i = 0; i < scene.views.size(); ++i) {
    for (int k = 0; k < 3500; ++k) {
      const int row = 60 + k * 71 % (scene.surface.values.rows - 120);
      const int column = 60 + k * 113 % (scene.surface.values.cols - 120);
      const cv::Point2d centre = scene.surface.place.centre(column, row);
      const cv::Vec3d ecef =
          to_map.inverse({centre.x, centre.y, double{scene.surface.values(row, column)}});
      const double before = obstruction(scene.surface, to_map, scene.views[i].truth, ecef, highest);
      if (std::abs(before) < 0.2) continue;              // the line grazes something
      if (scene.visible[i](row, column) == 0) continue;  // beside the image
      const bool is_visible = scene.visible[i](row, column) == 255;
      ++compared;
      occluded += before > 0;
      wrong += is_visible == (before > 0);
    }
  }
  MESSAGE(compared << " cells, " << occluded << " occluded, " << wrong << " judged otherwise");
  CHECK(compared > 1000);
  CHECK(occluded > 15);
  CHECK(wrong == 0);
}

TEST_CASE("true surface and images agree; a planted pointing error is found to 0.05 px") {
  for (const cv::Point2d error : {cv::Point2d(0, 0), cv::Point2d(1.1, -0.6)}) {
    SatelliteSceneSpec spec = small(500);
    spec.views[1].pointing_error = error;
    const TemporaryFolder folder;
    const auto images = xgm::testing::written_images(folder / "scene", make_satellite_scene(spec));
    const Raster surface = read_raster(folder / "scene/dsm.tif");
    const auto photo = xgm::testing::photo_check(surface, images[0], images[1]);
    MESSAGE("planted " << error << " px, found " << photo.along << " along, " << photo.across
                       << " across, " << photo.patches << " patches");
    CHECK(photo.patches > 200);
    CHECK(std::abs(photo.along + error.x) < 0.05);
    CHECK(std::abs(photo.across + error.y) < 0.05);
  }
}

TEST_CASE("the same seed gives the same files for any number of threads, another seed others") {
  const TemporaryFolder folder;
  SatelliteSceneSpec spec = small(96);
  const auto write = [&](const std::string& name, int threads) {
    const ThreadLimit limit(threads);
    write_satellite_scene(folder / name, make_satellite_scene(spec));
  };
  write("one", 1);
  write("three", 3);
  spec.seed = 2;
  write("other", 1);
  for (const char* file :
       {"image_1.tif", "image_2.tif", "dsm.tif", "dem.tif", "visible_2.tif", "scene.yaml"}) {
    const auto bytes = [&](const std::string& name) {
      return read_file(folder / name + "/" + file);
    };
    CHECK_MESSAGE(bytes("one") == bytes("three"), file);
    CHECK_MESSAGE(bytes("one") != bytes("other"), file);
  }
}

TEST_CASE("a written scene holds what was made") {
  const TemporaryFolder folder;
  SatelliteSceneSpec spec = small(96);
  spec.dem_datum = "egm96";
  spec.dem_error = 0;
  spec.dem_bias = 4;
  const SatelliteScene scene = make_satellite_scene(spec);
  const auto images = xgm::testing::written_images(folder / "scene", scene);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const RpcCamera made(scene.views[i].delivered);
    const auto point = made.localize({20, 70}, spec.lowest);
    REQUIRE(point);
    CHECK(cv::norm(images[i].camera.project(*point) - cv::Point2d(20, 70)) < 1e-5);
    const cv::Mat1f read = read_window(images[i], {{}, images[i].size});
    cv::Mat1f made_image;
    scene.images[i].convertTo(made_image, CV_32F);
    CHECK(cv::countNonZero(read != made_image) == 0);
  }
  // The coarse DEM lies above EGM96 in the file and is back above the ellipsoid once it is read.
  const auto dem = read_dem(folder / "scene/dem.tif");
  const int side = cvRound(spec.dem_posting / spec.posting);
  const cv::Mat1f block = scene.surface.values(cv::Rect(5 * side, 4 * side, side, side));
  const Raster raw = read_raster(folder / "scene/dem.tif");
  const CrsTransform to_wgs84(horizontal(raw.crs), "EPSG:4326");
  const cv::Point2d centre = raw.place.centre(5, 4);
  const cv::Vec3d place = to_wgs84.forward({centre.x, centre.y, 0});
  CHECK(dem->height(place[0], place[1]).value_or(0) ==
        doctest::Approx(cv::mean(block)[0] + 4).epsilon(1e-5));
  CHECK(double{raw.values(4, 5)} < cv::mean(block)[0] - 30);
  const std::string yaml = read_file(folder / "scene/scene.yaml");
  CHECK(contains(yaml, "datum: egm96"));
  CHECK(contains(yaml, "rpc_residual_px"));
  folder.write("notes.txt", "mine");
  CHECK(contains(error_of([&] { write_satellite_scene(folder.path(), scene); }),
                 "holds other files than a generated scene"));
}
