// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/plugins/maps.hpp"
#include "tests/support/simd.hpp"
#include "tests/support/support.hpp"
#include "xgm/plugin.hpp"

using xgm::DisparityMap;
using xgm::MatchResult;
using xgm::Status;
using xgm::testing::identical;

namespace {

MatchResult run(const std::string& yaml, const DisparityMap& forward, const DisparityMap& reverse) {
  return xgm::testing::stage<xgm::Consistency>(yaml)->run({forward, reverse}, xgm::Context{});
}

int nearest(double position) { return static_cast<int>(std::floor(position + 0.5)); }

/// Where pixel x of a view points in the other one.
int pointed(const DisparityMap& map, int y, int x) {
  return nearest(x - static_cast<double>(map.disparity(y, x)));
}

/// Does the line of sight through x meet the disparity function of `other`?
bool is_visible(const DisparityMap& other, double threshold, int y, int x) {
  for (int q = 0; q < other.size().width; ++q) {
    if (!other.has_disparity(y, q)) continue;
    const int here = pointed(other, y, q);
    if (here == x) return true;
    if (q + 1 == other.size().width || !other.has_disparity(y, q + 1)) continue;
    const double jump = static_cast<double>(other.disparity(y, q)) - other.disparity(y, q + 1);
    const int there = pointed(other, y, q + 1);
    if (std::abs(jump) <= threshold && std::min(here, there) <= x && x <= std::max(here, there)) {
      return true;
    }
  }
  return false;
}

DisparityMap oracle(const DisparityMap& map, const DisparityMap& other, double threshold) {
  DisparityMap result = map.clone();
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (!map.has_disparity(y, x)) continue;
      const int q = pointed(map, y, x);
      const bool meets = q >= 0 && q < map.size().width && other.has_disparity(y, q);
      if (meets &&
          std::abs(static_cast<double>(map.disparity(y, x)) + other.disparity(y, q)) <= threshold) {
        continue;
      }
      const bool visible = is_visible(other, threshold, y, x);
      result.invalidate(y, x, visible ? Status::mismatched : Status::occluded);
    }
  }
  return result;
}

DisparityMap uniform_map(cv::Size size, float disparity) {
  DisparityMap map(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) map.set(y, x, disparity);
  }
  return map;
}

/// A square of disparity `near` before a plane of disparity `far`, as each view sees it.
struct SquareScene {
  static constexpr int kWidth = 40, kHeight = 20, kLeft = 18, kTop = 6, kSide = 9;
  int far_disparity, near_disparity;
  DisparityMap forward, reverse;

  SquareScene(int far_, int near_)
      : far_disparity(far_),
        near_disparity(near_),
        forward(view(far_, near_, 0)),
        reverse(view(-far_, -near_, near_)) {}

  static DisparityMap view(int far_, int near_, int shift) {
    DisparityMap map = uniform_map({kWidth, kHeight}, static_cast<float>(far_));
    for (int y = kTop; y < kTop + kSide; ++y) {
      for (int x = kLeft; x < kLeft + kSide; ++x) map.set(y, x - shift, static_cast<float>(near_));
    }
    return map;
  }
  /// The background just left of the square is hidden behind it in the match view.
  bool hidden(int y, int x) const {
    return y >= kTop && y < kTop + kSide && x < kLeft &&
           x >= kLeft - (near_disparity - far_disparity);
  }
  /// The background just right of the square's image is hidden behind it in the base view.
  bool hidden_in_reverse(int y, int x) const {
    const int right = kLeft + kSide - near_disparity;
    return y >= kTop && y < kTop + kSide && x >= right &&
           x < right + near_disparity - far_disparity;
  }
};

const std::vector<std::pair<int, int>> kDisparityPairs{{2, 7}, {-9, -4}, {-2, 3}, {0, 6}};

}  // namespace

TEST_CASE("lrrl keeps and classifies as the definition says") {
  for (const cv::Size size : xgm::testing::kMapSizes) {
    for (const double threshold : {0.0, 0.5, 1.0, 3.0}) {
      for (const double invalid : {0.0, 0.3, 1.0}) {
        CAPTURE(size);
        CAPTURE(threshold);
        const auto forward = xgm::testing::random_map(size, {-6, 4, 0.25, invalid}, 31);
        const auto reverse = xgm::testing::random_map(size, {-4, 6, 0.25, invalid}, 32);
        const std::string yaml = "{type: lrrl, threshold: " + std::to_string(threshold) + "}";
        const DisparityMap expected = oracle(forward, reverse, threshold);
        const DisparityMap expected_reverse = oracle(reverse, forward, threshold);
        xgm::testing::with_each_simd_target([&] {
          const MatchResult result = run(yaml, forward, reverse);
          CHECK(identical(result.forward, expected));
          CHECK(identical(*result.reverse, expected_reverse));
          CHECK(xgm::testing::is_consistent(result.forward));
          CHECK(xgm::testing::is_consistent(*result.reverse));
        });
      }
    }
  }
}

TEST_CASE("lrrl finds exactly the occluded band beside a square, in both views") {
  for (const auto& [far_disparity, near_disparity] : kDisparityPairs) {
    const SquareScene scene(far_disparity, near_disparity);
    const MatchResult result = run("lrrl", scene.forward, scene.reverse);
    for (int y = 0; y < SquareScene::kHeight; ++y) {
      for (int x = 0; x < SquareScene::kWidth; ++x) {
        CAPTURE(x);
        const int q = x - far_disparity, q_reverse = x + far_disparity;
        const bool outside = q < 0 || q >= SquareScene::kWidth;
        const bool outside_reverse = q_reverse < 0 || q_reverse >= SquareScene::kWidth;
        const Status forward = scene.hidden(y, x) || outside ? Status::occluded : Status::matched;
        REQUIRE(result.forward.at(y, x) == forward);
        const bool lost = scene.hidden_in_reverse(y, x) || outside_reverse;
        REQUIRE(result.reverse->at(y, x) == (lost ? Status::occluded : Status::matched));
      }
    }
  }
}

TEST_CASE("interpolation fills the occluded band with the background, in both views") {
  for (const auto& [far_disparity, near_disparity] : kDisparityPairs) {
    const SquareScene scene(far_disparity, near_disparity);
    const MatchResult checked = run("lrrl", scene.forward, scene.reverse);
    const std::string fill = "{type: discontinuity_preserving_interpolation, background: ";
    const auto left = xgm::testing::stage<xgm::Filter>(fill + "lowest}");
    const auto right = xgm::testing::stage<xgm::Filter>(fill + "highest}");
    const DisparityMap forward = left->run(checked.forward, {}, {});
    const DisparityMap reverse = right->run(*checked.reverse, {}, {});
    for (int y = 0; y < SquareScene::kHeight; ++y) {
      for (int x = 0; x < SquareScene::kWidth; ++x) {
        CAPTURE(x);
        REQUIRE(forward.disparity(y, x) == scene.forward.disparity(y, x));
        REQUIRE(reverse.disparity(y, x) == scene.reverse.disparity(y, x));
      }
    }
  }
}

TEST_CASE("lrrl calls a wrong disparity mismatched where the other view sees the pixel") {
  DisparityMap forward = uniform_map({30, 1}, 4);
  const DisparityMap reverse = uniform_map({30, 1}, -4);
  forward.set(0, 15, 9);
  const MatchResult result = run("lrrl", forward, reverse);
  CHECK(result.forward.at(0, 15) == Status::mismatched);
  CHECK(result.forward.at(0, 3) == Status::occluded);  // sees beyond the match image
  CHECK(result.forward.at(0, 4) == Status::matched);
}

TEST_CASE("lrrl sees no gap where a slanted surface is stretched") {
  // The other view's targets jump from 9 to 11 at a step of one: pixel 10 lies on the surface.
  DisparityMap reverse = uniform_map({20, 1}, 0);
  for (int q = 10; q < 20; ++q) reverse.set(0, q, -1);
  DisparityMap forward = uniform_map({20, 1}, 0);
  forward.set(0, 10, 7);
  CHECK(run("lrrl", forward, reverse).forward.at(0, 10) == Status::mismatched);
}

TEST_CASE("lrrl fails pixels that point at a pixel without disparity, keeps older reasons") {
  DisparityMap forward = uniform_map({9, 1}, 0), reverse = uniform_map({9, 1}, 0);
  reverse.invalidate(0, 3, Status::ambiguous);
  forward.invalidate(0, 5, Status::masked);
  const MatchResult result = run("lrrl", forward, reverse);
  CHECK(result.forward.at(0, 3) == Status::occluded);
  CHECK(result.reverse->at(0, 3) == Status::ambiguous);
  CHECK(result.forward.at(0, 5) == Status::masked);
  CHECK(result.reverse->at(0, 5) == Status::occluded);
}

TEST_CASE("lrrl checks each map against the other one unchecked") {
  // Base 5 points at match 5, which points at base 7, which points at match 7: a chain of failures
  // must not depend on which map is checked first.
  DisparityMap forward = uniform_map({9, 1}, 0), reverse = uniform_map({9, 1}, 0);
  reverse.set(0, 5, -2);
  const MatchResult one_way = run("lrrl", forward, reverse);
  const MatchResult other_way = run("lrrl", reverse, forward);
  CHECK(identical(one_way.forward, *other_way.reverse));
  CHECK(identical(*one_way.reverse, other_way.forward));
  CHECK(!one_way.forward.has_disparity(0, 5));
  CHECK(one_way.forward.has_disparity(0, 7));
}

TEST_CASE("lrrl keeps a difference of exactly the threshold and rounds half pixels rightwards") {
  DisparityMap forward = uniform_map({9, 1}, 2), reverse = uniform_map({9, 1}, -3);
  CHECK(run("lrrl", forward, reverse).forward.has_disparity(0, 5));
  CHECK(!run("{type: lrrl, threshold: 0.99}", forward, reverse).forward.has_disparity(0, 5));
  forward.set(0, 5, 1.5F);  // x - d = 3.5: pixel 4
  reverse = uniform_map({9, 1}, 40);
  reverse.set(0, 4, -1.5F);
  CHECK(run("lrrl", forward, reverse).forward.has_disparity(0, 5));
}

TEST_CASE("lrrl calls occluded what points far beyond the other view") {
  DisparityMap forward = uniform_map({9, 1}, 0), reverse = uniform_map({9, 1}, 0);
  forward.set(0, 2, 4e9F);
  forward.set(0, 6, -1e30F);
  reverse.invalidate(0, 2, Status::peak);
  reverse.invalidate(0, 6, Status::peak);
  const MatchResult result = run("lrrl", forward, reverse);
  CHECK(result.forward.at(0, 2) == Status::occluded);
  CHECK(result.forward.at(0, 6) == Status::occluded);
  CHECK(result.forward.has_disparity(0, 4));
  CHECK(result.reverse->has_disparity(0, 4));
}

TEST_CASE("lrrl without a reverse map says what to do") {
  MatchResult result;
  result.forward = uniform_map({3, 3}, 0);
  const auto lrrl = xgm::testing::stage<xgm::Consistency>("lrrl");
  CHECK_THROWS_AS(lrrl->run(result, xgm::Context{}), xgm::Error);
}
