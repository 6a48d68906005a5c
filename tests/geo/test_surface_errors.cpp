// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/evaluation/surface_errors.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::test_data;

TEST_CASE("shares are of the truth's cells, errors of the cells that have both") {
  const float none = NAN;
  const cv::Mat1f truth = (cv::Mat1f(1, 6) << 10, 10, 10, 10, 10, none);
  const cv::Mat1f surface = (cv::Mat1f(1, 6) << 10.5F, 8, 13, none, 10, 10);
  const SurfaceErrors errors = compare_surfaces(surface, truth);
  CHECK(errors.truth_cells == 5);
  CHECK(errors.cells == 4);
  CHECK(errors.completeness == doctest::Approx(2.0 / 5));
  CHECK(errors.coverage == doctest::Approx(4.0 / 5));
  CHECK(errors.median_error == doctest::Approx(1.25));
  CHECK(errors.signed_median == doctest::Approx(0.25));
  CHECK(errors.rmse == doctest::Approx(std::sqrt((0.25 + 4 + 9) / 4)));
  CHECK_THROWS_AS(compare_surfaces(surface, cv::Mat1f(2, 2, 1.0F)), UsageError);
  CHECK(std::isnan(compare_surfaces(cv::Mat1f(1, 1, none), cv::Mat1f(1, 1, 1.0F)).rmse));
}

TEST_CASE("a surface is brought onto the truth's grid: place, CRS and datum") {
  Raster truth{cv::Mat1f(20, 20, 0.0F), {360000, 7650000, 1, -1}, "EPSG:32740", {}};
  Raster surface{cv::Mat1f(50, 50), {359990, 7650010, 1, -1}, "EPSG:32740", {}};
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 50; ++x) surface.values(y, x) = static_cast<float>(x + 100 * y);
  }
  CHECK(on_grid_of(surface, truth)(3, 4) == doctest::Approx(14 + 1300));
  surface.place.left += 0.25;
  CHECK(on_grid_of(surface, truth)(3, 4) == doctest::Approx(13.75 + 1300));

  Raster above_geoid = truth;
  above_geoid.crs = with_heights("EPSG:32740", "egm96");
  surface.crs = with_heights("EPSG:32740", "ellipsoid");
  // The geoid lies above the ellipsoid here, so heights above it are smaller.
  CHECK(on_grid_of(surface, above_geoid)(3, 4) ==
        doctest::Approx(13.75 + 1300 - 2.264).epsilon(1e-3));
  CHECK(contains(comparison_text(surface, truth), "surface WGS 84 ellipsoid, truth not said"));
  CHECK(contains(comparison_text(surface, surface), "heights of both: WGS 84 ellipsoid"));
  truth.crs.clear();
  CHECK_THROWS_AS(on_grid_of(surface, truth), UsageError);
  CHECK_THROWS_AS(comparison_text(surface, truth), UsageError);
  CHECK(contains(comparison_text(truth, truth), "cell by cell"));
}

TEST_CASE("LiDAR and two surfaces of another program: its figures to the last digit given") {
  const auto data = test_data("LiDAR of the multi-view benchmark");
  if (!data) return;
  const std::string folder = (*data / "satellite/iarpa-mvs-lidar/").string();
  const Raster truth = read_raster(folder + "Z3.tif");
  const auto errors_of = [&](const char* name, bool level) {
    Raster surface = read_raster(folder + name);
    if (level) {
      surface.values -= compare_surfaces(surface.values, truth.values).signed_median;
    }
    return compare_surfaces(on_grid_of(surface, truth), truth.values);
  };
  const auto rounded = [](double value, int digits) {
    return std::round(value * std::pow(10, digits)) / std::pow(10, digits);
  };
  const SurfaceErrors median = errors_of("rs3_fu_heNEW_N50_med.tif", false);
  CHECK(rounded(median.completeness, 3) == 0.556);
  CHECK(rounded(median.median_error, 3) == 0.859);
  CHECK(rounded(median.rmse, 2) == 6.64);
  CHECK(rounded(median.coverage, 3) == 1.0);
  CHECK(rounded(median.signed_median, 3) == -0.511);
  const SurfaceErrors k_medians = errors_of("rs3_fu_heNEW_N50_kmedianslow.tif", false);
  CHECK(rounded(k_medians.completeness, 3) == 0.324);
  CHECK(rounded(k_medians.median_error, 3) == 1.294);
  CHECK(rounded(k_medians.rmse, 2) == 7.45);
  CHECK(rounded(k_medians.coverage, 3) == 0.911);
  CHECK(rounded(errors_of("rs3_fu_heNEW_N50_med.tif", true).completeness, 3) == 0.573);
  CHECK(rounded(errors_of("rs3_fu_heNEW_N50_kmedianslow.tif", true).completeness, 3) == 0.562);
}
