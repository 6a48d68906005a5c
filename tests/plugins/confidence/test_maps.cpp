// SPDX-License-Identifier: Apache-2.0
// Confidences that read maps, beside their definitions written plainly.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"

using namespace xgm;
using namespace xgm::testing;

namespace {

const ImagePair kNoPair;

template <class Oracle>
void check_each(const cv::Mat1f& found, const DisparityMap& map, const Oracle& oracle) {
  REQUIRE(found.size() == map.size());
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (map.at(y, x) != Status::matched) {
        REQUIRE(std::isnan(found(y, x)));
      } else {
        REQUIRE(found(y, x) == doctest::Approx(oracle(y, x)).epsilon(1e-6));
      }
    }
  }
}

double difference_confidence(const DisparityMap& map, const DisparityMap& other, int y, int x) {
  for (int q = 0; q < other.size().width; ++q) {
    const double position = x - static_cast<double>(map.disparity(y, x));
    if (!(q - 0.5 <= position && position < q + 0.5) || !other.has_disparity(y, q)) continue;
    const double difference =
        std::abs(static_cast<double>(map.disparity(y, x)) + other.disparity(y, q));
    return 0.25 / (0.25 + difference);
  }
  return 0;
}

double agreement(const DisparityMap& map, int radius, double limit, int y, int x) {
  double agreeing = 0, others = 0;
  for (int v = y - radius; v <= y + radius; ++v) {
    for (int u = x - radius; u <= x + radius; ++u) {
      const bool inside = v >= 0 && v < map.size().height && u >= 0 && u < map.size().width;
      if (!inside || (v == y && u == x)) continue;
      ++others;
      if (!map.has_disparity(v, u)) continue;
      if (std::abs(static_cast<double>(map.disparity(v, u)) - map.disparity(y, x)) <= limit) {
        ++agreeing;
      }
    }
  }
  return others == 0 ? 1 : agreeing / others;
}

}  // namespace

TEST_CASE("left_right_difference compares with the pixel that is pointed at") {
  const auto confidence = stage<Confidence>("{type: left_right_difference, half: 0.25}");
  CHECK(confidence->needs_other_view());
  for (const cv::Size size : kMapSizes) {
    const DisparityMap map = random_map(size, {-6, 6, 0.25, 0.3}, 41);
    const DisparityMap other = random_map(size, {-6, 6, 0.25, 0.3}, 42);
    const cv::Mat1f found = confidence->run({kNoPair, map, nullptr, &other}, {});
    check_each(found, map, [&](int y, int x) { return difference_confidence(map, other, y, x); });
  }
}

TEST_CASE("left_right_difference is 0 for what points far outside") {
  DisparityMap map({3, 1}), other({3, 1});
  for (int x = 0; x < 3; ++x) other.set(0, x, 0);
  map.set(0, 0, 1e30F);
  map.set(0, 1, -1e30F);
  map.set(0, 2, 3);
  const cv::Mat1f found =
      stage<Confidence>("left_right_difference")->run({kNoPair, map, nullptr, &other}, {});
  for (int x = 0; x < 3; ++x) CHECK(found(0, x) == 0);
}

TEST_CASE("agreement counts the pixels around that have about the same disparity") {
  for (const auto& [window, limit] : {std::pair{3, 0.0}, {5, 1.0}, {11, 2.5}}) {
    const auto confidence =
        stage<Confidence>("{type: agreement, window: " + std::to_string(window) +
                          ", max_difference: " + std::to_string(limit) + "}");
    for (const cv::Size size : kMapSizes) {
      const DisparityMap map = random_map(size, {-2, 3, 0.5, 0.3}, 43);
      const int radius = window / 2;
      const double most = limit;
      check_each(confidence->run({kNoPair, map}, {}), map,
                 [&](int y, int x) { return agreement(map, radius, most, y, x); });
    }
  }
}

TEST_CASE("so_far is the confidence that the map has, in memory of its own") {
  DisparityMap map = random_map({7, 5}, {}, 44);
  map.confidence = cv::Mat1f(map.size(), 0.25F);
  const cv::Mat1f found = stage<Confidence>("so_far")->run({kNoPair, map}, {});
  CHECK(cv::countNonZero(found == 0.25F) == 35);
  CHECK(found.data != map.confidence.data);
}

TEST_CASE("weighted is the mean by weight, arithmetic or geometric") {
  DisparityMap map({4, 1}), other({4, 1});
  for (int x = 0; x < 4; ++x) {
    map.set(0, x, 0);
    other.set(0, x, x == 3 ? 0.5F : 0);
  }
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  map.confidence = (cv::Mat1f(1, 4) << 0, 1, kNaN, 0.25F);
  const Evidence evidence{kNoPair, map, nullptr, &other};
  const std::string parts =
      "{type: weighted, confidences: [so_far, left_right_difference], weights: [3, 1]";
  const cv::Mat1f sum = stage<Confidence>(parts + "}")->run(evidence, {});
  CHECK(sum(0, 0) == doctest::Approx(0.25));
  CHECK(sum(0, 1) == 1);
  CHECK(std::isnan(sum(0, 2)));
  CHECK(sum(0, 3) == doctest::Approx(0.75 * 0.25 + 0.25 * 0.5));
  const cv::Mat1f product = stage<Confidence>(parts + ", mean: geometric}")->run(evidence, {});
  CHECK(product(0, 0) == 0);
  CHECK(product(0, 1) == 1);
  CHECK(std::isnan(product(0, 2)));
  CHECK(product(0, 3) == doctest::Approx(std::pow(0.25, 0.75) * std::pow(0.5, 0.25)));
}

TEST_CASE("weighted: a weight of 0 leaves a confidence out") {
  DisparityMap map({1, 1}), other({1, 1});
  map.set(0, 0, 0);
  other.set(0, 0, 0);
  map.confidence = cv::Mat1f::zeros(1, 1);
  for (const char* mean : {"arithmetic", "geometric"}) {
    const auto confidence = stage<Confidence>(
        std::string("{type: weighted, confidences: [so_far, left_right_difference], weights: [0, 2]"
                    ", mean: ") +
        mean + "}");
    CHECK(confidence->run({kNoPair, map, nullptr, &other}, {})(0, 0) == 1);
  }
}

TEST_CASE("weighted needs what any of its parts needs") {
  const auto of = [](const std::string& parts, const std::string& weights) {
    return stage<Confidence>("{type: weighted, confidences: [" + parts + "], weights: [" + weights +
                             "]}");
  };
  CHECK(of("agreement, peak_ratio", "1, 1")->needs_sums());
  CHECK_FALSE(of("agreement", "1")->needs_sums());
  CHECK(of("agreement, left_right_difference", "1, 1")->needs_other_view());
  CHECK_FALSE(of("agreement", "1")->needs_other_view());
  CHECK(of("so_far, agreement", "1, 1")->needs_confidence());
  CHECK_FALSE(of("agreement", "1")->needs_confidence());
}

TEST_CASE("weighted refuses weights that fit no confidence") {
  for (const char* faulty : {"{type: weighted, confidences: [agreement], weights: [1, 2]}",
                             "{type: weighted, confidences: [agreement], weights: [0]}",
                             "{type: weighted, confidences: [], weights: []}"}) {
    CHECK_THROWS_AS(stage<Confidence>(faulty), UsageError);
  }
}
