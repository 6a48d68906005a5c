// SPDX-License-Identifier: Apache-2.0
// Rectified pairs: corresponding points lie in one row, and the way there leads back.
#include <cmath>
#include <random>

#include "geo/cameras.hpp"
#include "support/support.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/geo/camera/read_rpc.hpp"
#include "xgm/geo/image/keypoints.hpp"
#include "xgm/geo/stage/pointing.hpp"
#include "xgm/geo/stage/range_prior.hpp"
#include "xgm/geo/stage/rectification.hpp"

using namespace xgm;
using namespace xgm::geo;
using xgm::testing::contains;
using xgm::testing::error_of;
using xgm::testing::geo_stage;
using xgm::testing::image_with;
using xgm::testing::test_data;

namespace {

struct Check {
  double parallax = 0;    ///< RMS of what corresponding points differ in y, px
  double round_trip = 0;  ///< largest difference of from(to()) and to(from()), px
  double middle = 0;      ///< largest |disparity| of the middle height, px
  int signs = 0;          ///< sum of the signs of what higher ground adds to the disparity
  int points = 0;
};

/// At places that the rectification was not made of.
Check check(const SatelliteImage& base, const SatelliteImage& match, const cv::Rect& window,
            const HeightInterval& heights, const Rectification& geometry) {
  Check result;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int k = 0; k < 4000; ++k) {
    const cv::Point2d pixel(window.x + (window.width - 1) * share(random),
                            window.y + (window.height - 1) * share(random));
    const double range = heights.max - heights.min;
    const double height = heights.min + range * (k % 3 == 0 ? 0.5 : share(random));
    const auto point = base.camera.localize(pixel, height);
    const auto higher = base.camera.localize(pixel, height + range / 10);
    if (!point || !higher) continue;
    const cv::Point2d there = match.camera.project(*point);
    const cv::Point2d a = geometry.from_base(pixel), b = geometry.from_match(there);
    result.parallax += std::pow(a.y - b.y, 2);
    if (k % 3 == 0) result.middle = std::max(result.middle, std::abs(a.x - b.x));
    const double there_higher = geometry.from_match(match.camera.project(*higher)).x;
    result.signs += there_higher < b.x ? 1 : -1;
    result.round_trip = std::max({result.round_trip, cv::norm(geometry.to_base(a) - pixel),
                                  cv::norm(geometry.to_match(b) - there),
                                  cv::norm(geometry.from_base(geometry.to_base(a)) - a)});
    CHECK((a.x >= 0 && a.y >= -0.5 && a.x < geometry.size().width &&
           a.y < geometry.size().height - 0.5));
    ++result.points;
  }
  result.parallax = std::sqrt(result.parallax / result.points);
  return result;
}

void require_sound(const std::string& rectifier, const SatelliteImage& base,
                   const SatelliteImage& match, const cv::Rect& window,
                   const HeightInterval& heights, double max_middle) {
  CAPTURE(base.name);
  const auto geometry =
      geo_stage<Rectifier>(rectifier)->run(base, match, window, heights, Context());
  const Check found = check(base, match, window, heights, *geometry);
  MESSAGE(base.name << ", " << rectifier << " of " << window.width << " x " << window.height
                    << " px: y-parallax " << found.parallax << " px RMS (said "
                    << geometry->residual() << "), there and back " << found.round_trip
                    << " px, middle height " << found.middle << " px, " << found.points
                    << " points");
  REQUIRE(found.points > 3000);
  CHECK(found.parallax <= 0.1);
  CHECK(geometry->residual() <= 0.1);
  CHECK(found.round_trip < 1e-6);
  CHECK(found.middle <= max_middle);
  CHECK(std::abs(found.signs) == found.points);
}

}  // namespace

TEST_CASE("rectified pairs of generated cameras: one row, there and back, one sign of height") {
  const auto [base, match] = xgm::testing::curved_pair();
  require_sound("affine", base, match, {4000, 3000, 1000, 1000}, {1000, 1300}, 0.5);
  const cv::Rect whole({}, base.size);
  require_sound("piecewise", base, match, whole, {1000, 1300}, 0.01);
  const auto affine = geo_stage<Rectifier>("affine")->run(base, match, whole, {1000, 1300}, {});
  MESSAGE("affine on the whole image: " << affine->residual() << " px");
  CHECK(affine->residual() > 0.2);  // so that the other one shows something
}

TEST_CASE("windows of odd sizes, of single pixels and flat ground are rectified") {
  const auto [base, match] = xgm::testing::curved_pair();
  for (const char* rectifier : {"affine", "piecewise"}) {
    for (const cv::Rect& window : {cv::Rect(501, 333, 517, 1), cv::Rect(5000, 5000, 1, 777),
                                   cv::Rect(17, 9999, 1, 1), cv::Rect(300, 300, 313, 211)}) {
      CAPTURE(rectifier);
      CAPTURE(window);
      for (const double height : {0.0, 150.0}) {
        const HeightInterval heights{1200 - height, 1200 + height};
        const auto geometry =
            geo_stage<Rectifier>(rectifier)->run(base, match, window, heights, Context());
        CHECK(geometry->residual() < 0.1);
        CHECK(geometry->size().height >= 1);
        const auto point = base.camera.localize(window.tl(), 1200);
        REQUIRE(point);
        const cv::Point2d a = geometry->from_base(window.tl());
        const cv::Point2d b = geometry->from_match(match.camera.project(*point));
        CHECK(std::abs(a.y - b.y) < 0.1);
        CHECK(std::abs(a.x - b.x) < 0.5);
        CHECK(cv::norm(geometry->to_base(a) - cv::Point2d(window.tl())) < 1e-6);
      }
    }
  }
}

TEST_CASE("what cannot be rectified is refused with the image and a remedy") {
  const auto [first, second] = xgm::testing::curved_pair();
  const SatelliteImage &base = first, &match = second;  // clang 14 captures no bindings
  for (const char* rectifier : {"affine", "piecewise"}) {
    const auto message = [&](const cv::Rect& window, const HeightInterval& heights,
                             const SatelliteImage& other) {
      return error_of([&, &one = base] {
        geo_stage<Rectifier>(rectifier)->run(one, other, window, heights, Context());
      });
    };
    CAPTURE(rectifier);
    CHECK(contains(message({0, 0, 0, 5}, {0, 1}, match), "curved: the window to rectify is empty"));
    CHECK(contains(message({0, 0, 100, 100}, {5, 1}, match), "no heights"));
    CHECK(contains(message({90000, 0, 100, 100}, {1000, 1300}, match), "reaches no ground"));
    CHECK(contains(message({0, 0, 100, 100}, {90000, 99000}, match), "reaches no ground"));
    CHECK(contains(message({0, 0, 100, 100}, {1000, 1300}, base), "larger convergence angle"));
  }
}

TEST_CASE("Réunion: after pointing, one affine map per image lays points into one row") {
  const auto data = test_data("a Pleiades pair");
  if (!data) return;
  const std::string folder = (*data / "satellite/s2p/tests/data/input_pair/").string();
  const std::vector<SatelliteImage> images{open_image(folder + "img_01.tif"),
                                           open_image(folder + "img_02.tif")};
  const HeightInterval heights{2270, 2377};
  const auto pointed = geo_stage<Pointing>("keypoints")
                           ->run(images, {{0, 1}}, GroundKnowledge{nullptr, heights}, Context());
  const cv::Rect whole({}, images[0].size);
  require_sound("affine", pointed[0], pointed[1], whole, heights, 0.5);
  require_sound("piecewise", pointed[0], pointed[1], whole, heights, 0.01);
  // And not in theory alone: key points of the images lie in one row, too.
  const auto geometry =
      geo_stage<Rectifier>("affine")->run(pointed[0], pointed[1], whole, heights, Context());
  std::vector<double> parallax;
  for (const KeypointMatch& m : match_keypoints(pointed[0], pointed[1], whole, heights, 5)) {
    parallax.push_back(geometry->from_base(m.base).y - geometry->from_match(m.match).y);
  }
  REQUIRE(parallax.size() > 100);
  std::nth_element(parallax.begin(), parallax.begin() + std::ssize(parallax) / 2, parallax.end());
  MESSAGE(parallax.size() << " key points differ in y by " << parallax[parallax.size() / 2]
                          << " px in the median");
  CHECK(std::abs(parallax[parallax.size() / 2]) <= 0.1);
}

TEST_CASE("vendors' cameras: whole images of 10,000 px are rectified piece by piece") {
  const auto data = test_data("pairs of vendors' RPC files");
  if (!data) return;
  const std::string folder = (*data / "satellite/").string();
  const auto open = [&](const std::string& name, cv::Size size) {
    return image_with(name, RpcCamera(read_rpc(folder + name).front()), size);
  };
  struct Pair {
    std::string base, match;
    cv::Rect window;
    HeightInterval heights;
  };
  for (const Pair& p :
       {Pair{"s2p/tests/data/input_pair/img_01.tif",
             "s2p/tests/data/input_pair/img_02.tif",
             {-4500, -4500, 10000, 10000},
             {1500, 2500}},
        Pair{"asp/src/asp/Camera/tests/wv_mvp_1.xml",
             "asp/src/asp/Camera/tests/wv_mvp_2.xml",
             {10000, 5000, 10000, 10000},
             {0, 300}},
        Pair{"shareloc/tests/data/rpc/PHR1B_P_201709281038045_SEN_PRG_FC_178608-001.geom",
             "shareloc/tests/data/rpc/PHR1B_P_201709281038393_SEN_PRG_FC_178609-001.geom",
             {5000, 5000, 10000, 10000},
             {0, 1000}}}) {
    const SatelliteImage base = open(p.base, {10000, 10000}), match = open(p.match, {10000, 10000});
    const auto affine = geo_stage<Rectifier>("affine")->run(base, match, p.window, p.heights, {});
    MESSAGE("affine: " << affine->residual() << " px");
    require_sound("piecewise", base, match, p.window, p.heights, 0.01);
  }
}
