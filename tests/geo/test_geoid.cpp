// SPDX-License-Identifier: Apache-2.0
// Surfaces whose heights are above a geoid.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geo/satellite_desk.hpp"
#include "support/support.hpp"
#include "xgm/geo/evaluation/surface_errors.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/io/file.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::Outcome;
using xgm::testing::SatelliteDesk;

// The name alone is egm96.
TEST_CASE("--geoid: heights are less by the geoid's, and the files say what they are above") {
  const SatelliteDesk desk;
  const std::string run =
      "run dsm_tsgm8 --images scene/image_1.tif scene/image_2.tif --dem scene/dem.tif ";
  REQUIRE(desk.call(run + "--output plain").exit_code == 0);
  const Outcome outcome = desk.call(run + "--output geoid --geoid");
  CAPTURE(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const Raster plain = read_raster(desk / "plain/dsm.tif");
  const Raster above = read_raster(desk / "geoid/dsm.tif");
  REQUIRE(plain.values.size() == above.values.size());
  const CrsTransform to_degrees(plain.crs, "EPSG:4326");
  const CrsTransform undulation(with_heights("EPSG:4326", "egm96"), std::string(kWgs84));
  int compared = 0;
  double worst = 0;
  for (int y = 0; y < plain.values.rows; ++y) {
    for (int x = 0; x < plain.values.cols; ++x) {
      CHECK(std::isnan(plain.values(y, x)) == std::isnan(above.values(y, x)));
      if (std::isnan(plain.values(y, x))) continue;
      const cv::Point2d centre = plain.place.centre(x, y);
      const cv::Vec3d place = to_degrees.forward({centre.x, centre.y, 0});
      const double n = undulation.forward({place[0], place[1], 0})[2];
      worst =
          std::max(worst, std::abs(double{plain.values(y, x)} - double{above.values(y, x)} - n));
      ++compared;
    }
  }
  CHECK(compared > 1000);
  CHECK(worst < 1e-3);
  CHECK(has_heights(above.crs));
  CHECK(heights_name(above.crs) == "EGM96 height");
  CHECK(above.metadata.at("vertical_datum") == "EGM96 height");
  CHECK(plain.metadata.at("vertical_datum") == "WGS 84 ellipsoid");
  const auto record = nlohmann::json::parse(read_file(desk / "geoid/run.json"));
  CHECK(record["grid"]["heights_above"] == "EGM96 height");
  // Compared with each other, both are the same ground again, and the comparison says how.
  double apart = 0;
  const cv::Mat1f brought = on_grid_of(above, plain);
  for (int y = 0; y < plain.values.rows; ++y) {
    for (int x = 0; x < plain.values.cols; ++x) {
      if (std::isnan(brought(y, x)) || std::isnan(plain.values(y, x))) continue;
      apart = std::max(apart, std::abs(double{brought(y, x)} - double{plain.values(y, x)}));
    }
  }
  CHECK(apart < 1e-3);
  CHECK(contains(comparison_text(above, plain),
                 "its heights (EGM96 height) become the truth's (WGS 84 ellipsoid)"));
  // As a DEM, both are the same ground again.
  const auto a = read_dem(desk / "plain/dsm.tif"), b = read_dem(desk / "geoid/dsm.tif");
  CHECK(std::abs(a->bounds().max - b->bounds().max) < 1e-3);
}

TEST_CASE("--geoid: what PROJ does not know, or lacks the grid of, is refused before any work") {
  const SatelliteDesk desk;
  const std::string run = "run dsm_tsgm8 --images scene/image_1.tif scene/image_2.tif ";
  const Outcome missing = desk.call(run + "--geoid egm2008 --output out");
  CHECK(missing.exit_code == 2);
  CHECK(contains(missing.errors, "geoid egm2008"));
  CHECK(contains(missing.errors, "lacks the grid"));
  const Outcome unknown = desk.call(run + "--geoid sea --output out");
  CHECK(unknown.exit_code == 2);
  CHECK(contains(unknown.errors, "'sea' is no vertical datum"));
  CHECK_FALSE(std::filesystem::exists(desk / "out"));
}
