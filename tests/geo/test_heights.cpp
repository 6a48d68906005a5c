// SPDX-License-Identifier: Apache-2.0
// Datums, rasters and DEMs.
#include <cmath>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/camera/rpc_camera.hpp"
#include "xgm/geo/ground/dem.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::TemporaryFolder;
using xgm::testing::test_data;

namespace {

/// A slope to the east on longitudes 10 to 10.02 and latitudes 50 to 49.98, 100 columns and rows.
Raster slope(const Crs& crs) {
  Raster raster{cv::Mat1f(100, 100), {10, 50, 2e-4, -2e-4}, crs, {}};
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) raster.values(y, x) = 100 + static_cast<float>(x);
  }
  return raster;
}

std::string error_of(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("EGM96 lies where the grid says, and a missing grid is never left out quietly") {
  const CrsTransform to_ellipsoid(with_heights("EPSG:4326", "egm96"), std::string(kWgs84));
  CHECK(to_ellipsoid.forward({55.65, -21.23, 0})[2] == doctest::Approx(2.264).epsilon(1e-2));
  CHECK(to_ellipsoid.forward({5.194, 44.207, 100})[2] == doctest::Approx(150.863).epsilon(1e-3));
  const std::string missing =
      error_of([] { CrsTransform(with_heights("EPSG:4326", "egm2008"), std::string(kWgs84)); });
  CHECK(missing.find("lacks the grid") != std::string::npos);
  CHECK(error_of([] { with_heights("EPSG:4326", "sea"); }).find("egm96") != std::string::npos);
  CHECK(error_of([] { has_heights("EPSG:0"); }).find("EPSG:32740") != std::string::npos);
}

TEST_CASE("UTM zones, and coordinates there and back, east first") {
  CHECK(utm_crs(55.65, -21.2) == "EPSG:32740");
  CHECK(utm_crs(-180, 0) == "EPSG:32601");
  CHECK(utm_crs(180, 10) == "EPSG:32660");
  CHECK(epsg_code("EPSG:32740") == 32740);
  CHECK(epsg_code(with_heights("EPSG:32740", "egm96")) == 32740);
  CHECK(epsg_code(horizontal("EPSG:2154")) == 2154);  // as WKT
  CHECK_FALSE(epsg_code("+proj=tmerc +lat_0=3 +lon_0=50 +x_0=17 +ellps=bessel +type=crs"));
  const CrsTransform to_utm("EPSG:4326", "EPSG:32740");
  const cv::Vec3d utm = to_utm.forward({55.65, -21.23, 0});
  CHECK(utm[0] == doctest::Approx(359886).epsilon(1e-3));   // east
  CHECK(utm[1] == doctest::Approx(7651630).epsilon(1e-3));  // north
  CHECK(std::abs(to_utm.inverse(utm)[0] - 55.65) < 1e-9);
}

TEST_CASE("a raster comes back as it was written: values, place, CRS, nodata, metadata") {
  const TemporaryFolder folder;
  Raster raster = slope("EPSG:4326");
  raster.values(3, 4) = NAN;
  raster.metadata["vertical_datum"] = "WGS 84 ellipsoid";
  write_raster(folder / "r.tif", raster);
  const Raster again = read_raster(folder / "r.tif");
  CHECK(again.values.size() == raster.values.size());
  CHECK(std::isnan(again.values(3, 4)));
  CHECK(again.values(3, 5) == raster.values(3, 5));
  CHECK(again.place.left == doctest::Approx(10));
  CHECK(again.place.step_y == doctest::Approx(-2e-4));
  CHECK(is_wgs84(again.crs));
  CHECK(again.metadata.at("vertical_datum") == "WGS 84 ellipsoid");
  CHECK(error_of([&] { read_raster(folder / "none.tif"); }).find("none.tif") != std::string::npos);
  CHECK(error_of([&] { read_raster(folder / "r.tif", 2); }).find("no band 2") != std::string::npos);
}

TEST_CASE("a DEM is bilinear between the centres of its cells, and has no height beyond") {
  const Dem dem(slope(with_heights("EPSG:4326", "ellipsoid")), "slope");
  CHECK(dem.height(10 + 2e-4 * 10.5, 49.99) == doctest::Approx(110).epsilon(1e-9));
  CHECK(dem.height(10 + 2e-4 * 10.75, 49.99) == doctest::Approx(110.25).epsilon(1e-9));
  CHECK_FALSE(dem.height(10 + 2e-4 * 0.4, 49.99));  // beside the first centre
  CHECK_FALSE(dem.height(9, 49.99));
  CHECK(dem.bounds().min == doctest::Approx(100));
  CHECK(dem.bounds().max == doctest::Approx(199));
  CHECK(error_of([] { Dem(slope("EPSG:4326"), "slope"); }).find("slope,egm96") !=
        std::string::npos);
}

TEST_CASE("a hole in a DEM has no height, and a line of sight that comes in there meets nothing") {
  Raster raster = slope(with_heights("EPSG:4326", "ellipsoid"));
  raster.values(50, 50) = NAN;
  const Dem dem(std::move(raster), "hole");
  CHECK_FALSE(dem.height(10 + 2e-4 * 50.9, 50 - 2e-4 * 50.5));
  CHECK(dem.height(10 + 2e-4 * 51.6, 50 - 2e-4 * 50.5));
}

TEST_CASE("a line of sight meets the surface where its height is the surface's") {
  const Dem dem(slope(with_heights("EPSG:4326", "ellipsoid")), "slope");
  RpcModel model{.column = {500, 500},
                 .row = {500, 500},
                 .longitude = {10.01, 0.01},
                 .latitude = {49.99, 0.01},
                 .height = {150, 500},
                 .column_ratio = {},
                 .row_ratio = {}};
  model.column_ratio.denominator[0] = model.row_ratio.denominator[0] = 1;
  model.column_ratio.numerator[1] = 1;
  model.column_ratio.numerator[3] = 0.3;  // oblique
  model.row_ratio.numerator[2] = -1;
  const RpcCamera camera(model);
  for (const cv::Point2d pixel : {cv::Point2d(500, 500), cv::Point2d(300.25, 720.5)}) {
    const auto point = camera.localize(pixel, dem);
    REQUIRE(point);
    CHECK(cv::norm(camera.project(*point) - pixel) < 1e-6);
    CHECK(std::abs(*dem.height(point->longitude, point->latitude) - point->height) < 1e-3);
  }
  CHECK_FALSE(camera.localize({-200, 500}, dem));
}

TEST_CASE("SRTM above EGM96 at Ventoux") {
  const auto data = test_data("an SRTM tile");
  if (!data) return;
  const std::string tile =
      (*data / "satellite/shareloc/tests/data/dtm/srtm_ventoux/srtm90_non_void_filled/N44E005.hgt")
          .string();
  const auto dem = read_dem(tile + ",egm96");
  const auto height = dem->height(5.193406151946, 44.208058078);
  REQUIRE(height);
  CHECK(std::abs(*height - 503.51202) < 1e-3);
}
