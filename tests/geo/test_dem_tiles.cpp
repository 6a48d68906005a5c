// SPDX-License-Identifier: Apache-2.0
// DEMs of several files.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/ground/dem.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

/// Hills on longitudes 10 to 10.02 and latitudes 50 to 49.98, 100 columns and rows.
Raster hills() {
  Raster raster{cv::Mat1f(100, 100), {10, 50, 2e-4, -2e-4}, "EPSG:4326", {}};
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      raster.values(y, x) =
          static_cast<float>(100 + 20 * std::sin(x * 0.3) + 15 * std::cos(y * 0.2));
    }
  }
  return raster;
}

Raster part(const Raster& whole, const cv::Rect& cells) {
  Raster raster = whole;
  raster.values = whole.values(cells).clone();
  raster.place.left += cells.x * whole.place.step_x;
  raster.place.top += cells.y * whole.place.step_y;
  return raster;
}

struct Tiles : TemporaryFolder {
  Tiles() {
    write_raster(*this / "whole.tif", whole);
    write_raster(*this / "a.tif", part(whole, {0, 0, 40, 100}));
    write_raster(*this / "b.tif", part(whole, {40, 0, 60, 55}));   // beside a, no cell in common
    write_raster(*this / "c.tif", part(whole, {38, 50, 62, 50}));  // over a part of both
  }
  std::string file(const std::string& name) const { return *this / (name + ".tif,ellipsoid"); }
  Raster whole = hills();
};

/// The largest difference of heights at places between cells; all must have one.
double difference(const HeightField& a, const HeightField& b) {
  double largest = 0;
  for (int k = 0; k < 97 * 97; ++k) {
    const double x = 10 + 2e-4 * (1 + k % 97 + 0.37), y = 50 - 2e-4 * (1 + k / 97 + 0.61);
    const auto here = a.height(x, y), there = b.height(x, y);
    REQUIRE(here);
    REQUIRE(there);
    largest = std::max(largest, std::abs(*here - *there));
  }
  return largest;
}

}  // namespace

TEST_CASE("tiles have no seam: heights are those of the whole, in any order, and of a folder") {
  const Tiles tiles;
  const auto whole = read_dem(tiles.file("whole"));
  CHECK(difference(*read_dem(std::vector{tiles.file("a"), tiles.file("b"), tiles.file("c")}),
                   *whole) < 1e-6);
  CHECK(difference(*read_dem(std::vector{tiles.file("c"), tiles.file("b"), tiles.file("a")}),
                   *whole) < 1e-6);
  std::filesystem::remove(tiles / "whole.tif");
  tiles.write("README.txt", "not a tile");
  CHECK(difference(*read_dem(tiles.path() + ",ellipsoid"), *whole) < 1e-6);
  CHECK(dem_files({tiles.path() + ",ellipsoid"}).size() == 3);
}

TEST_CASE("a VRT is a DEM like any other") {
  const Tiles tiles;
  tiles.write("tiles.vrt",
              "<VRTDataset rasterXSize=\"100\" rasterYSize=\"100\"><SRS>EPSG:4326</SRS>"
              "<GeoTransform>10, 2e-4, 0, 50, 0, -2e-4</GeoTransform>"
              "<VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource>"
              "<SourceFilename relativeToVRT=\"1\">whole.tif</SourceFilename></SimpleSource>"
              "</VRTRasterBand></VRTDataset>");
  CHECK(difference(*read_dem(tiles / "tiles.vrt,ellipsoid"), *read_dem(tiles.file("whole"))) <
        1e-6);
}

TEST_CASE("where tiles of other grids or datums meet, the first that has a height counts") {
  const Tiles tiles;
  Raster coarse{cv::Mat1f(20, 20, 500.0F), {9.99, 50.01, 2e-3, -2e-3}, "EPSG:4326", {}};
  write_raster(tiles / "coarse.tif", coarse);
  const auto dem = read_dem(std::vector{tiles.file("a"), tiles.file("coarse")});
  CHECK(*dem->height(10.004, 49.99) ==
        doctest::Approx(*read_dem(tiles.file("a"))->height(10.004, 49.99)));
  CHECK(*dem->height(10.015, 49.99) == doctest::Approx(500));
  CHECK(dem->bounds().max == 500);
  const auto above_geoid = read_dem(std::vector{tiles.file("a"), tiles / "coarse.tif,egm96"});
  CHECK(*above_geoid->height(10.015, 49.99) > 530);
}

TEST_CASE("a gap between tiles has no height") {
  const Tiles tiles;
  const auto dem = read_dem(std::vector{tiles.file("a"), tiles.file("b")});
  CHECK(dem->height(10.015, 49.995));
  CHECK_FALSE(dem->height(10.015, 49.982));
}

TEST_CASE("only what lies in a box is read, and heights there are the same") {
  const Tiles tiles;
  const auto whole = read_dem(tiles.file("whole"));
  const DegreeBox box(10.004, 49.984, 10.006, 49.986);
  const auto dem = read_dem(std::vector{tiles.file("a"), tiles.file("b"), tiles.file("c")}, box);
  for (int k = 0; k < 100; ++k) {
    const double x = box[0] + 2e-5 * (k % 10), y = box[1] + 2e-5 * (k / 10);
    CHECK(std::abs(*dem->height(x, y) - *whole->height(x, y)) < 1e-6);
  }
  CHECK_FALSE(dem->height(10.018, 49.99));
  CHECK(
      contains(error_of([&] { read_dem(std::vector{tiles.file("a")}, DegreeBox(20, 49, 21, 50)); }),
               "a.tif: this DEM covers longitudes"));
}
