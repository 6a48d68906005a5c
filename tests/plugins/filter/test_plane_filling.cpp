// SPDX-License-Identifier: Apache-2.0
// What plane_filling promises, on scenes whose truth is known.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/plugins/maps.hpp"
#include "tests/support/simd.hpp"
#include "tests/support/support.hpp"
#include "xgm/plugin.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

DisparityMap run(const DisparityMap& map, const ImagePair& pair, const std::string& more = "") {
  return stage<Filter>("{type: plane_filling" + more + "}")->run(map, pair, Context{});
}

const cv::Size kSize(90, 60);
const cv::Rect kCard(40, 10, 30, 40);  // in front of a wall

double wall(int y, int x) { return 4 + 0.05 * x + 0.03 * y; }

/// Texture of the wall and of the card, of different levels, at any place.
double wall_level(double x, double y) {
  return 60 + 25 * std::sin(1.1 * x + 0.7 * y) * std::sin(0.5 * x);
}
double card_level(double x, double y) {
  return 190 + 25 * std::sin(0.9 * x - 1.3 * y) * std::sin(0.7 * x);
}

constexpr double kCardDisparity = 16;

bool on_card(int y, int x) { return kCard.contains({x, y}); }
double truth(int y, int x) { return on_card(y, x) ? kCardDisparity : wall(y, x); }

/// The wall's x in the base image that is seen at x of the match image: x - wall(y, x) solved.
double wall_x(int y, double x) { return (x + 4 + 0.03 * y) / 0.95; }

ImagePair card_before_wall() {
  ImagePair pair{Image(cv::Mat1f(kSize)), Image(cv::Mat1f(kSize))};
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const double card_x = x + kCardDisparity;
      const bool card = on_card(y, static_cast<int>(card_x));
      pair.base.planes[0](y, x) =
          static_cast<float>(on_card(y, x) ? card_level(x, y) : wall_level(x, y));
      pair.match.planes[0](y, x) =
          static_cast<float>(card ? card_level(card_x, y) : wall_level(wall_x(y, x), y));
    }
  }
  return pair;
}

/// The true map; pixels of `hole` have lost their disparity.
DisparityMap true_map(const cv::Rect& hole, Status why) {
  DisparityMap map(kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      map.set(y, x, static_cast<float>(truth(y, x)));
      if (hole.contains({x, y})) map.invalidate(y, x, why);
    }
  }
  return map;
}

/// The largest error within `area`.
double error(const DisparityMap& map, const cv::Rect& area) {
  double largest = 0;
  for (int y = area.y; y < area.br().y; ++y) {
    for (int x = area.x; x < area.br().x; ++x) {
      REQUIRE(map.has_disparity(y, x));
      largest = std::max(largest, std::abs(double{map.disparity(y, x)} - truth(y, x)));
    }
  }
  return largest;
}

/// A map of a generated scene with holes of all kinds.
DisparityMap holed(cv::Size size) { return random_map(size, {-3, 9, 0.25, 0.4}, 8); }

}  // namespace

TEST_CASE("plane_filling continues slanted planes to a fraction of a pixel") {
  const cv::Rect hole(8, 15, 20, 25);
  const DisparityMap filled = run(true_map(hole, Status::mismatched), card_before_wall());
  CHECK(error(filled, hole) < 0.02);
  CHECK(filled.at(20, 15) == Status::filled);
  CHECK(filled.at(0, 0) == Status::matched);
  // What stands beside it fills with one of the disparities around: off by as much as the wall is
  // slanted over half of the hole.
  const DisparityMap flat =
      stage<Filter>("discontinuity_preserving_interpolation")
          ->run(true_map(hole, Status::mismatched), card_before_wall(), Context{});
  CHECK(error(flat, hole) > 0.3);
}

TEST_CASE("plane_filling fills what the card hides with the wall, and the card with the card") {
  const ImagePair pair = card_before_wall();
  // Left of a near object the other view shows no wall.
  const cv::Rect hidden(kCard.x - 12, kCard.y, 12, kCard.height);
  // A small segment of the wall may have a plane that is a little off; the card is 9 px off.
  CHECK(error(run(true_map(hidden, Status::occluded), pair), hidden) < 0.3);
  // The status is no verdict: a strip of the card that was lost with it comes back as card. The
  // edge itself is found to a pixel.
  const cv::Rect both(kCard.x - 12, kCard.y, 18, kCard.height);
  for (const Status why : {Status::occluded, Status::mismatched}) {
    const DisparityMap filled = run(true_map(both, why), pair);
    CHECK(error(filled, {kCard.x - 12, kCard.y + 1, 11, kCard.height - 2}) < 0.02);
    CHECK(error(filled, {kCard.x + 1, kCard.y + 1, 5, kCard.height - 2}) < 0.02);
  }
}

TEST_CASE("plane_filling: the right view is the left one in a mirror") {
  // Mirrored about the vertical, base and match, disparities change their sign and near is low.
  const auto mirrored = [](const auto& matrix) {
    auto result = matrix.clone();
    for (int y = 0; y < matrix.rows; ++y) {
      for (int x = 0; x < matrix.cols; ++x) result(y, x) = matrix(y, matrix.cols - 1 - x);
    }
    return result;
  };
  const cv::Rect both(kCard.x - 12, kCard.y, 18, kCard.height);
  const DisparityMap map = true_map(both, Status::occluded);
  const ImagePair pair = card_before_wall();
  ImagePair other{Image(mirrored(pair.base.planes[0])), Image(mirrored(pair.match.planes[0]))};
  DisparityMap map_other = map.clone();
  map_other.disparity = mirrored(cv::Mat1f(-map.disparity));
  map_other.status = mirrored(map.status);
  const DisparityMap expected = run(map, pair);
  const auto difference = [&](const DisparityMap& filled) {
    return cv::norm(mirrored(cv::Mat1f(-filled.disparity)), expected.disparity, cv::NORM_INF);
  };
  CHECK(difference(run(map_other, other, ", background: highest")) < 0.02);
  other.is_reverse = true;
  CHECK(difference(run(map_other, other)) < 0.02);
  CHECK(difference(run(map_other, other, ", background: highest")) > 1);
}

TEST_CASE("plane_filling replaces outliers if it is asked to") {
  const ImagePair pair = card_before_wall();
  DisparityMap map = true_map({}, Status::matched);
  const cv::Point top(15, 25);  // of a cone that is not there
  for (int y = top.y - 4; y <= top.y + 4; ++y) {
    for (int x = top.x - 4; x <= top.x + 4; ++x) {
      const double height = std::max(0.0, 4 - std::hypot(x - top.x, y - top.y));
      map.set(y, x, static_cast<float>(truth(y, x) + height));
    }
  }
  CHECK(identical(run(map, pair), map));
  const DisparityMap cleaned = run(map, pair, ", outliers: 1");
  CHECK(error(cleaned, {{}, kSize}) < 1.01);
  CHECK(error(cleaned, {top.x - 2, top.y - 2, 5, 5}) < 0.05);
  CHECK(cleaned.at(top.y, top.x) == Status::filled);
  CHECK(cleaned.at(top.y, top.x + 20) == Status::matched);
}

TEST_CASE("plane_filling fills from what there is: without texture, from one pixel, from nothing") {
  const ImagePair flat{Image(cv::Mat1f(kSize, 90.0F)), Image(cv::Mat1f(kSize, 90.0F))};
  DisparityMap map(kSize, Status::mismatched);
  CHECK(identical(run(map, flat), map));
  map.set(30, 45, 3.5F);
  const DisparityMap one = run(map, flat);
  CHECK(one.disparity(30, 0) == 3.5F);    // on a path to the pixel
  CHECK_FALSE(one.has_disparity(29, 0));  // on none
  CHECK(one.at(30, 45) == Status::matched);
  const ImagePair single{Image(cv::Mat1f(1, 1, 90.0F)), Image(cv::Mat1f(1, 1, 90.0F))};
  CHECK(identical(run(drawn_map({"."}), single), drawn_map({"."})));
  CHECK(identical(run(drawn_map({"3"}), single), drawn_map({"3"})));
}

TEST_CASE("plane_filling neither fills nor reads masked pixels") {
  ImagePair pair{random_guide(kSize, 3, 4).base, random_guide(kSize, 3, 9).base};
  pair.base.valid = random_mask(kSize, 0.2, 5);
  pair.match.valid = random_mask(kSize, 0.2, 6);
  const DisparityMap map = holed(kSize);
  const DisparityMap filled = run(map, pair);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const bool stays = map.at(y, x) == Status::masked || !pair.base.is_valid(y, x);
      if (stays) CHECK(filled.at(y, x) == map.at(y, x));
    }
  }
  for (Image* image : {&pair.base, &pair.match}) {
    for (cv::Mat1f& plane : image->planes) plane.setTo(255, image->valid == 0);
  }
  CHECK(identical(run(map, pair), filled));
}

TEST_CASE("plane_filling: same bytes on any number of threads and any SIMD target") {
  for (const cv::Size size : kMapSizes) {
    const ImagePair pair = random_guide(size, 3, 4);
    const DisparityMap map = holed(size);
    const DisparityMap expected = run(map, pair, ", outliers: 1");
    CHECK(is_consistent(expected));
    for (const int count : {1, 2, 3, 8}) {
      const ThreadLimit threads(count);
      CHECK(identical(run(map, pair, ", outliers: 1"), expected));
    }
    with_each_simd_target([&] { CHECK(identical(run(map, pair, ", outliers: 1"), expected)); });
  }
}
