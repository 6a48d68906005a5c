// SPDX-License-Identifier: Apache-2.0
// Cameras on generated models, and on the vendors' files.
#include <cmath>
#include <random>

#include "support/support.hpp"
#include "xgm/geo/camera/read_rpc.hpp"
#include "xgm/geo/camera/rpc_camera.hpp"

using namespace xgm;
using namespace xgm::geo;

namespace {

/// A model near an affine camera, with terms of every order.
RpcModel small_model() {
  RpcModel model{.column = {5000, 5000},
                 .row = {4000, 4000},
                 .longitude = {55.7, 0.1},
                 .latitude = {-21.2, 0.08},
                 .height = {1300, 1200},
                 .column_ratio = {},
                 .row_ratio = {}};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> small(-1e-5, 1e-5);
  for (RpcRatio* ratio : {&model.column_ratio, &model.row_ratio}) {
    for (std::size_t i = 0; i < 20; ++i) {
      ratio->numerator[i] = small(random);
      ratio->denominator[i] = small(random);
    }
    ratio->denominator[0] = 1;
  }
  model.column_ratio.numerator[1] = 1.1;
  model.column_ratio.numerator[3] = 0.1;
  model.row_ratio.numerator[2] = -1.05;
  model.row_ratio.numerator[3] = 0.02;
  return model;
}

/// The quotient as STDI-0002 writes it, term by term.
double naive(const RpcRatio& ratio, double L, double P, double H) {
  const auto sum = [&](const RpcPolynomial& c) {
    return c[0] + c[1] * L + c[2] * P + c[3] * H + c[4] * L * P + c[5] * L * H + c[6] * P * H +
           c[7] * L * L + c[8] * P * P + c[9] * H * H + c[10] * P * L * H + c[11] * L * L * L +
           c[12] * L * P * P + c[13] * L * H * H + c[14] * L * L * P + c[15] * P * P * P +
           c[16] * P * H * H + c[17] * L * L * H + c[18] * P * P * H + c[19] * H * H * H;
  };
  return sum(ratio.numerator) / sum(ratio.denominator);
}

/// Largest error of project(localize()), px, on a grid over the model's domain; counts failures.
double round_trip_error(const RpcCamera& camera, int& failures) {
  const RpcModel& m = camera.model();
  double worst = 0;
  for (int k = 0; k < 11 * 11 * 5; ++k) {
    const cv::Point2d pixel(m.column.value(-1 + 0.2 * (k % 11)),
                            m.row.value(-1 + 0.2 * (k / 11 % 11)));
    const double height = m.height.value(-1 + 0.5 * (k / 121));
    const auto point = camera.localize(pixel, height);
    if (!point) {
      ++failures;
      continue;
    }
    worst = std::max(worst, cv::norm(camera.project(*point) - pixel));
  }
  return worst;
}

}  // namespace

TEST_CASE("geodetic and Cartesian coordinates: known points, and there and back") {
  // The semi-axes of WGS 84.
  CHECK(cv::norm(to_ecef({0, 0, 0}) - cv::Vec3d(6378137, 0, 0)) < 1e-9);
  CHECK(cv::norm(to_ecef({90, 0, 10}) - cv::Vec3d(0, 6378147, 0)) < 1e-8);
  CHECK(cv::norm(to_ecef({0, 90, 0}) - cv::Vec3d(0, 0, 6356752.314245179)) < 1e-8);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const GeoPoint point{180 * unit(random), 90 * unit(random), 9e6 * std::pow(unit(random), 3)};
    if (point.height < -6e6) continue;
    const GeoPoint again = to_geodetic(to_ecef(point));
    CHECK(cv::norm(to_ecef(again) - to_ecef(point)) < 1e-7);
    CHECK(std::abs(again.height - point.height) < 1e-6);
  }
}

TEST_CASE("projection is the quotient of the polynomials of STDI-0002") {
  const RpcModel model = small_model();
  const RpcCamera camera(model);
  const GeoPoint point{55.73, -21.24, 2000};
  const double L = 0.3, P = -0.5, H = 7.0 / 12;
  const cv::Point2d pixel = camera.project(point);
  CHECK(pixel.x ==
        doctest::Approx(5000 + 5000 * naive(model.column_ratio, L, P, H)).epsilon(1e-12));
  CHECK(pixel.y == doctest::Approx(4000 + 4000 * naive(model.row_ratio, L, P, H)).epsilon(1e-12));
}

TEST_CASE("localize inverts project, singly and in batches, and says where it cannot") {
  const RpcCamera camera(small_model());
  int failures = 0;
  CHECK(round_trip_error(camera, failures) < 1e-6);
  CHECK(failures == 0);
  CHECK_FALSE(camera.localize({1e7, 0}, 1000));
  CHECK_FALSE(camera.localize({NAN, 0}, 1000));
  CHECK_FALSE(camera.localize({0, 0}, INFINITY));
  CHECK_FALSE(RpcCamera(RpcModel{}).localize({0, 0}, 0));  // 0 / 0 everywhere

  std::vector<cv::Point2d> pixels{{10, 20}, {1e7, 0}, {5000, 4000}};
  std::vector<double> heights{100, 100, 2000};
  std::vector<GeoPoint> points(3);
  std::vector<std::uint8_t> found(3);
  CHECK(camera.localize(pixels, heights, points, found) == 2);
  CHECK(found == std::vector<std::uint8_t>{1, 0, 1});
  std::vector<cv::Point2d> again(3);
  camera.project(points, again);
  CHECK(cv::norm(again[0] - pixels[0]) < 1e-6);
  CHECK(cv::norm(again[2] - pixels[2]) < 1e-6);
}

TEST_CASE("a crop's camera sees the same points in its own pixels") {
  const RpcCamera camera(small_model());
  const GeoPoint point{55.73, -21.24, 2000};
  const cv::Point2d moved = camera.cropped({100, 30.5}).project(point);
  CHECK(cv::norm(moved - (camera.project(point) - cv::Point2d(100, 30.5))) < 1e-9);
}

TEST_CASE(
    "rays pass through the points of their pixel at every height; angles are those of the ray") {
  const RpcCamera camera(small_model());
  const cv::Point2d pixel(3000, 5000);
  const auto ray = camera.ray(pixel);
  REQUIRE(ray);
  for (const double height : {200.0, 1300.0, 2400.0}) {
    const cv::Vec3d from = to_ecef(*camera.localize(pixel, height)) - ray->origin;
    CHECK(cv::norm(from.cross(ray->direction)) < 1);  // m: the model bends it a little
  }
  const auto angles = camera.view_angles(pixel);
  REQUIRE(angles);
  // The point moves by 0.1 / 1.1 of 0.1 degrees, some 945 m, to the west as it rises by 1200 m.
  CHECK(angles->incidence == doctest::Approx(38).epsilon(0.1));
  CHECK(angles->azimuth == doctest::Approx(280).epsilon(0.1));
}

TEST_CASE("a reduced image's camera sees the same points in pixels that are larger") {
  const RpcCamera camera(small_model());
  const GeoPoint point = *camera.localize({41.5, 81.5}, 1200);  // the middle of 4 x 4 pixels
  CHECK(cv::norm(camera.reduced(4).project(point) - cv::Point2d(10, 20)) < 1e-6);
  const cv::Point2d edge = camera.reduced(4).project(*camera.localize({-0.5, -0.5}, 1300));
  CHECK(cv::norm(edge - cv::Point2d(-0.5, -0.5)) < 1e-6);
}
