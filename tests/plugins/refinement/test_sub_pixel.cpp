// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"
#include "xgm/plugin.hpp"

using xgm::AggregatedVolume;
using xgm::DisparityMap;
using xgm::Status;

namespace {

constexpr int kNoMatch = AggregatedVolume::kNoMatch;

AggregatedVolume one_pixel(const std::vector<int>& cells, int begin) {
  const int end = begin + static_cast<int>(cells.size());
  const auto shape =
      std::make_shared<const xgm::VolumeShape>(xgm::DisparityRange::uniform({1, 1}, {begin, end}));
  AggregatedVolume sums(shape, 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    sums.data()[i] = static_cast<std::uint16_t>(cells[i]);
  }
  return sums;
}

DisparityMap run(const std::string& yaml, const DisparityMap& map, const AggregatedVolume& sums) {
  return xgm::testing::stage<xgm::Refinement>(yaml)->run(map, sums, xgm::Context{});
}

/// What becomes of `disparity` at a pixel with these sums from disparity `begin` on.
float refined(const std::string& yaml, const std::vector<int>& cells, int begin, float disparity) {
  DisparityMap map(cv::Size(1, 1));
  map.set(0, 0, disparity);
  const DisparityMap result = run(yaml, map, one_pixel(cells, begin));
  CHECK(result.at(0, 0) == Status::matched);
  return result.disparity(0, 0);
}

/// Lowest point of the parabola through (-1, a), (0, b), (1, c), by Cramer's rule on its equations.
double vertex(double a, double b, double c) {
  const double quadratic = (a + c) / 2 - b, linear = (c - a) / 2;
  return -linear / (2 * quadratic);
}

/// Where the lines of slope -k through (-1, a) and +k through (1, c) meet, with the k for which one
/// of them passes through (0, b) and the other not above it. Tries both.
double corner(double a, double b, double c) {
  for (const double k : {a - b, c - b}) {
    const double left_at_0 = a - k, right_at_0 = c - k;
    if (left_at_0 <= b + 1e-9 && right_at_0 <= b + 1e-9) return (a - c) / (2 * k);
  }
  return std::nan("");
}

/// A volume of random convex-or-not sums and the map of its minima.
struct Scene {
  AggregatedVolume sums;
  DisparityMap map;
};

Scene random_scene(cv::Size size, int values, std::uint64_t seed) {
  xgm::testing::Random random(seed);
  cv::Mat1i begin(size), end(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      begin(y, x) = random.integer(-10, 9);
      end(y, x) = begin(y, x) + random.integer(0, 6);
    }
  }
  const auto shape = std::make_shared<const xgm::VolumeShape>(xgm::DisparityRange(begin, end));
  Scene scene{AggregatedVolume(shape, 0), DisparityMap(size)};
  for (std::int64_t i = 0; i < shape->cells(); ++i) {
    scene.sums.data()[i] = random.integer(0, 7) == 0
                               ? static_cast<std::uint16_t>(kNoMatch)
                               : static_cast<std::uint16_t>(random.integer(0, values - 1));
  }
  scene.map = xgm::testing::stage<xgm::Selection>("wta")->run(scene.sums, xgm::Context{});
  return scene;
}

template <class Shift>
void check_against(const std::string& yaml, const Scene& scene, Shift shift) {
  const auto& shape = scene.sums.shape();
  const DisparityMap result = run(yaml, scene.map, scene.sums);
  CHECK(xgm::testing::is_consistent(result));
  for (int y = 0; y < shape.height(); ++y) {
    for (int x = 0; x < shape.width(); ++x) {
      REQUIRE(result.at(y, x) == scene.map.at(y, x));
      if (!result.has_disparity(y, x)) continue;
      const int d = static_cast<int>(scene.map.disparity(y, x));
      double expected = d;
      if (d > shape.begin(y, x) && d + 1 < shape.end(y, x)) {
        const auto* cell = scene.sums.at(y, x) + (d - shape.begin(y, x));
        const bool complete = cell[-1] != kNoMatch && cell[1] != kNoMatch;
        const bool flat = cell[-1] == cell[0] && cell[1] == cell[0];
        if (complete && !flat) expected += shift(cell[-1], cell[0], cell[1]);
      }
      REQUIRE(result.disparity(y, x) == doctest::Approx(expected).epsilon(1e-6));
      REQUIRE(std::abs(result.disparity(y, x) - static_cast<float>(d)) <= 0.5F);
    }
  }
}

}  // namespace

TEST_CASE("parabola moves to the vertex of the parabola through three sums") {
  for (const cv::Size size : xgm::testing::kMapSizes) {
    for (const int values : {3, 60000}) {
      check_against("parabola", random_scene(size, values, 11), vertex);
    }
  }
}

TEST_CASE("equiangular moves to the corner of two lines of opposite slope") {
  for (const cv::Size size : xgm::testing::kMapSizes) {
    for (const int values : {3, 60000}) {
      check_against("equiangular", random_scene(size, values, 12), corner);
    }
  }
}

TEST_CASE("parabola finds the minimum of a sampled parabola, equiangular that of a sampled V") {
  for (const double minimum : {-4.4, -4.0, -3.75, -3.5, -3.25}) {
    std::vector<int> bowl, vee;
    for (int d = -8; d < 1; ++d) {
      bowl.push_back(static_cast<int>(std::lround(1000 + 400 * (d - minimum) * (d - minimum))));
      vee.push_back(static_cast<int>(std::lround(1000 + 400 * std::abs(d - minimum))));
    }
    const auto whole = static_cast<float>(std::lround(minimum));
    CHECK(refined("parabola", bowl, -8, whole) == doctest::Approx(minimum).epsilon(0.001));
    CHECK(refined("equiangular", vee, -8, whole) == doctest::Approx(minimum).epsilon(0.001));
  }
}

TEST_CASE("no sub-pixel shift without two matchable neighbours, and none on flat sums") {
  for (const std::string yaml : {"parabola", "equiangular"}) {
    CAPTURE(yaml);
    CHECK(refined(yaml, {5, 9, 30}, 3, 3) == 3.0F);
    CHECK(refined(yaml, {30, 9, 5}, 3, 5) == 5.0F);
    CHECK(refined(yaml, {5}, 3, 3) == 3.0F);
    CHECK(refined(yaml, {kNoMatch, 5, 9}, 3, 4) == 4.0F);
    CHECK(refined(yaml, {9, 5, kNoMatch}, 3, 4) == 4.0F);
    CHECK(refined(yaml, {5, 5, 5}, 3, 4) == 4.0F);
    CHECK(refined(yaml, {5, 5, 9}, 3, 4) == 3.5F);
  }
}

TEST_CASE("sub-pixel refinement leaves alone what is no whole minimum of the sums") {
  for (const std::string yaml : {"parabola", "equiangular"}) {
    CAPTURE(yaml);
    CHECK(refined(yaml, {9, 5, 2}, 3, 4) == 4.0F);
    CHECK(refined(yaml, {9, 5, 7}, 3, 4.25F) == 4.25F);
    CHECK(refined(yaml, {9, 5, 7}, 3, 4e9F) == 4e9F);
    CHECK(refined(yaml, {9, 5, 7}, 3, -4e9F) == -4e9F);
  }
}

TEST_CASE("sub-pixel shifts do not depend on a constant added to a pixel's sums") {
  for (const std::string yaml : {"parabola", "equiangular"}) {
    CHECK(refined(yaml, {9, 5, 7}, 0, 1) == refined(yaml, {60009, 60005, 60007}, 0, 1));
  }
}

TEST_CASE("sub-pixel refinement returns a map of its own") {
  const Scene scene = random_scene({5, 5}, 1000, 3);
  const DisparityMap before = scene.map.clone();
  run("parabola", scene.map, scene.sums);
  CHECK(xgm::testing::identical(scene.map, before));
}
