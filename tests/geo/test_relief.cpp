// SPDX-License-Identifier: Apache-2.0
// Scenes of real heights, and collections of images.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/synthesis/plan_views.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::TemporaryFolder;

namespace {

constexpr int kSide = 400;  // cells of 0.5 m

/// Level ground at 50 m with a house of 12 m in its middle, rough trees beside it, and a hole.
cv::Mat1f village() {
  cv::Mat1f heights(kSide, kSide, 50.0F);
  heights(cv::Rect(180, 185, 40, 30)) = 62.0F;
  for (int y = 120; y < 150; ++y) {
    for (int x = 180; x < 220; ++x) heights(y, x) = 56.0F + static_cast<float>((x * 7 + y * 5) % 4);
  }
  heights(cv::Rect(250, 190, 5, 6)) = std::numeric_limits<float>::quiet_NaN();
  return heights;
}

SatelliteSceneSpec spec_of(const std::string& file) {
  SatelliteSceneSpec spec;
  spec.size = 160;
  spec.relief_file = file;
  spec.relief_posting = 0.5;
  spec.noise = 0;
  spec.dem_posting = 10;
  spec.rpc_below = spec.rpc_above = 20;
  return spec;
}

/// Median deviation of grey levels from their median, of what the first image shows at a height.
double texture(const SatelliteScene& scene, float low, float high) {
  std::vector<double> greys;
  for (int y = 0; y < scene.images[0].rows; ++y) {
    for (int x = 0; x < scene.images[0].cols; ++x) {
      const float height = scene.heights[0](y, x);
      if (height > low && height < high) greys.push_back(scene.images[0](y, x));
    }
  }
  REQUIRE(greys.size() > 100);
  const auto median = [](std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  const double centre = median(greys);
  for (double& grey : greys) grey = std::abs(grey - centre);
  return median(greys);
}

}  // namespace

TEST_CASE("a scene of real heights has them, its lowest place where asked, and no holes") {
  const TemporaryFolder folder;
  write_raster(folder / "plain.tif", {village(), {}, {}, {}});
  write_raster(folder / "placed.tif", {village(), {400000, 5000000, 0.5, -0.5}, "EPSG:32632", {}});
  for (const std::string name : {"plain.tif", "placed.tif"}) {
    SatelliteSceneSpec spec = spec_of(folder / name);
    if (name == "placed.tif") spec.relief_posting = 9;  // what the file says counts
    const SatelliteScene scene = make_satellite_scene(spec);
    const cv::Mat1f& heights = scene.surface.values;
    const cv::Point middle(heights.cols / 2, heights.rows / 2);
    CHECK(heights(middle) == static_cast<float>(spec.lowest) + 12);
    CHECK(heights(middle + cv::Point(30, 0)) == static_cast<float>(spec.lowest));
    CHECK(std::none_of(heights.begin(), heights.end(), [](float h) { return std::isnan(h); }));
    CHECK(heights(middle + cv::Point(52, -7)) == static_cast<float>(spec.lowest));  // the hole
  }
}

TEST_CASE("smooth roofs of real heights have no texture, ground and trees have") {
  const TemporaryFolder folder;
  write_raster(folder / "village.tif", {village(), {}, {}, {}});
  const SatelliteSceneSpec spec = spec_of(folder / "village.tif");
  const SatelliteScene scene = make_satellite_scene(spec);
  const auto h = static_cast<float>(spec.lowest);
  const double roof = texture(scene, h + 11.9F, h + 12.1F);
  const double ground = texture(scene, h - 0.1F, h + 0.1F), trees = texture(scene, h + 5, h + 10);
  MESSAGE("deviation of grey levels: roof " << roof << ", ground " << ground << ", trees "
                                            << trees);
  CHECK(roof < 3);
  CHECK(ground > 20);
  CHECK(trees > 20);
}

TEST_CASE("heights in degrees, and a file of none, are refused") {
  const TemporaryFolder folder;
  write_raster(folder / "degrees.tif", {village(), {6, 45, 1e-5, -1e-5}, "EPSG:4326", {}});
  CHECK(contains(error_of([&] { make_satellite_cameras(spec_of(folder / "degrees.tif")); }),
                 "reproject it"));
  write_raster(folder / "empty.tif",
               {cv::Mat1f(9, 9, std::numeric_limits<float>::quiet_NaN()), {}, {}, {}});
  CHECK(contains(error_of([&] { make_satellite_cameras(spec_of(folder / "empty.tif")); }),
                 "has no heights"));
}

TEST_CASE("a collection has the images, dates and errors that were asked for") {
  const ViewPlan plan{
      .images = 12, .dates = 4, .incidence = 15, .sun_elevation = 20, .pointing_error = 1.5};
  const std::vector<SatelliteView> views = plan_views(plan, 3);
  REQUIRE(views.size() == 12);
  std::set<double> suns;
  double squares = 0, incidence = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    CHECK(views[i].date == static_cast<int>(i) % 4);
    suns.insert(views[i].sun_azimuth);
    CHECK(std::abs(views[i].sun_elevation - 20) <= 8);
    incidence += views[i].incidence / 12;
    squares += views[i].pointing_error.dot(views[i].pointing_error) / 24;
  }
  CHECK(suns.size() == 4);
  CHECK(incidence == doctest::Approx(15).epsilon(0.1));
  CHECK(std::sqrt(squares) == doctest::Approx(1.5).epsilon(0.4));
  CHECK(plan_views(plan, 3)[7].azimuth == views[7].azimuth);
  CHECK(plan_views(plan, 4)[7].azimuth != views[7].azimuth);
  CHECK(
      contains(error_of([] { plan_views({.images = 2, .dates = 3}, 1); }), "number of dates is 3"));
}
