// SPDX-License-Identifier: Apache-2.0
// A DEM tells what a pair cannot: errors along its epipolar lines.
#include <algorithm>
#include <cmath>

#include "geo/cameras.hpp"
#include "geo/recorder.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/camera/meeting.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/geo/image/keypoints.hpp"
#include "xgm/geo/stage/pointing.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::geo_stage;
using xgm::testing::Recorder;
using xgm::testing::test_data;

TEST_CASE("without a DEM there is nothing to align to") {
  const auto [one, two] = xgm::testing::curved_pair();
  CHECK(contains(error_of([&, &a = one, &b = two] {
                   geo_stage<Pointing>("align_to_dem")->run({a, b}, {{0, 1}}, {}, Context());
                 }),
                 "needs a DEM"));
}

TEST_CASE(
    "Réunion: an error planted along the epipolar line is found on a surface, and taken out") {
  const auto data = test_data("a Pleiades pair and its surface");
  if (!data) return;
  const std::string folder = (*data / "satellite/s2p/tests/data/").string();
  std::vector<SatelliteImage> images{open_image(folder + "input_pair/img_01.tif"),
                                     open_image(folder + "input_pair/img_02.tif")};
  const auto dem = read_dem(folder + "expected_output/pair/dsm.tif,ellipsoid");
  const GroundKnowledge ground{dem.get(), {2200, 2450}};
  const auto heights_above = [&](const std::vector<SatelliteImage>& pair) {
    std::vector<double> dz;
    for (const KeypointMatch& m :
         match_keypoints(pair[0], pair[1], {{}, pair[0].size}, ground.heights, 5)) {
      const auto a = pair[0].camera.ray(m.base), b = pair[1].camera.ray(m.match);
      REQUIRE((a && b));
      const GeoPoint point = to_geodetic(meet(*a, *b).point);
      const auto surface = dem->height(point.longitude, point.latitude);
      if (surface) dz.push_back(point.height - *surface);
    }
    REQUIRE(dz.size() > 100);
    std::sort(dz.begin(), dz.end());
    return dz[dz.size() / 2];
  };
  // 5 m of height along the line of the middle pixel.
  const cv::Point2d middle(512, 512);
  const auto low = images[0].camera.localize(middle, 2320);
  const auto high = images[0].camera.localize(middle, 2325);
  REQUIRE((low && high));
  const cv::Point2d planted = images[1].camera.project(*high) - images[1].camera.project(*low);
  images[1].camera = images[1].camera.cropped(-planted);
  const double before = heights_above(images);
  Recorder recorder;
  const auto aligned =
      geo_stage<Pointing>("align_to_dem")->run(images, {{0, 1}}, ground, Context(&recorder));
  const double after = heights_above(aligned);
  MESSAGE("key points lie " << before << " m above the surface, then " << after << " m; along "
                            << recorder.figures.at("img_01 img_02 along_px") << " px, across "
                            << recorder.figures.at("img_01 img_02 across_px") << " px");
  CHECK(std::abs(std::abs(before) - 5) < 0.3);
  CHECK(std::abs(after) < 0.1);
  CHECK(recorder.figures.at("img_01 img_02 height_m") == doctest::Approx(-5).epsilon(0.06));
  CHECK(std::abs(std::abs(recorder.figures.at("img_01 img_02 across_px")) - 0.77) < 0.1);
}
