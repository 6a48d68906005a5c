// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <limits>
#include <map>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"
#include "xgm/base/simd.hpp"
#include "xgm/plugin.hpp"

using xgm::DisparityMap;
using xgm::ImagePair;
using xgm::testing::identical;

namespace {

struct Settings {
  int radius;
  double sigma_space, sigma_range;
  std::string mode;
};

DisparityMap run(const Settings& s, const DisparityMap& map, const ImagePair& pair) {
  const std::string yaml = "{type: joint_bilateral, radius: " + std::to_string(s.radius) +
                           ", sigma_space: " + std::to_string(s.sigma_space) +
                           ", sigma_range: " + std::to_string(s.sigma_range) + ", mode: " + s.mode +
                           "}";
  return xgm::testing::stage<xgm::Filter>(yaml)->run(map, pair, xgm::Context{});
}

/// Weight of each disparity in the window of (y, x), in plain double.
std::map<float, double> votes(const Settings& s, const DisparityMap& map, const xgm::Image& guide,
                              int y, int x) {
  std::map<float, double> weights;
  for (int v = 0; v < map.size().height; ++v) {
    for (int u = 0; u < map.size().width; ++u) {
      if (std::abs(u - x) > s.radius || std::abs(v - y) > s.radius) continue;
      if (!map.has_disparity(v, u) || !guide.is_valid(v, u)) continue;
      double colour = 0;
      for (const cv::Mat1f& plane : guide.planes) {
        colour += std::abs(static_cast<double>(plane(v, u)) - static_cast<double>(plane(y, x)));
      }
      colour /= static_cast<double>(guide.planes.size());
      const double space = (u - x) * (u - x) + (v - y) * (v - y);
      weights[map.disparity(v, u)] +=
          std::exp(-space / (2 * s.sigma_space * s.sigma_space)) *
          std::exp(-colour * colour / (2 * s.sigma_range * s.sigma_range));
    }
  }
  return weights;
}

/// Weight below, at and above a value, in shares of all.
struct Split {
  double below = 0, at = 0, above = 0;
};
Split split(const std::map<float, double>& weights, float value) {
  Split result;
  double total = 0;
  for (const auto& [d, weight] : weights) total += weight;
  for (const auto& [d, weight] : weights) {
    (d < value ? result.below : d > value ? result.above : result.at) += weight / total;
  }
  return result;
}

double mean(const std::map<float, double>& weights) {
  double sum = 0, total = 0;
  for (const auto& [d, weight] : weights) {
    sum += weight * static_cast<double>(d);
    total += weight;
  }
  return sum / total;
}

template <class Check>
void for_each_pixel(const DisparityMap& map, const ImagePair& pair, const DisparityMap& result,
                    Check check) {
  REQUIRE(xgm::testing::is_consistent(result));
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      REQUIRE(result.at(y, x) == map.at(y, x));
      if (map.has_disparity(y, x) && pair.base.is_valid(y, x)) check(y, x);
    }
  }
}

/// Random maps and guides of every size, grey and colour, some with no-data pixels.
template <class Body>
void for_each_scene(const Settings& s, double invalid_share, Body body) {
  for (const cv::Size size : xgm::testing::kMapSizes) {
    for (const int planes : {1, 3}) {
      const DisparityMap map = xgm::testing::random_map(size, {-8, 8, 0.5, invalid_share}, 5);
      ImagePair pair = xgm::testing::random_guide(size, planes, 6);
      if (planes == 3) {
        pair.base.valid = cv::Mat1b(size, 1);
        pair.base.valid(size.height / 2, size.width / 2) = 0;
      }
      CAPTURE(size);
      CAPTURE(planes);
      body(map, pair, run(s, map, pair));
    }
  }
}

/// Weights are whole 65535ths, colour distances eighths of a grey level (far below sigma_range).
constexpr double kRounding = 0.005;

}  // namespace

TEST_CASE("joint_bilateral takes the weighted median of the definition") {
  for (const Settings& s : {Settings{1, 1, 10, "median"}, Settings{2, 2, 10, "median"},
                            Settings{4, 3, 20, "median"}, Settings{15, 5, 8, "median"}}) {
    for (const double invalid_share : {0.0, 0.4, 0.95}) {
      int exact = 0, all = 0;
      for_each_scene(s, invalid_share, [&](const auto& map, const auto& pair, const auto& result) {
        for_each_pixel(map, pair, result, [&](int y, int x) {
          const auto weights = votes(s, map, pair.base, y, x);
          const float d = result.disparity(y, x);
          REQUIRE(weights.count(d) == 1);
          const Split shares = split(weights, d);
          REQUIRE(shares.below < 0.5 + kRounding);
          REQUIRE(shares.below + shares.at > 0.5 - kRounding);
          exact += shares.below < 0.5 && shares.below + shares.at >= 0.5 ? 1 : 0;
          ++all;
        });
      });
      CHECK(exact >= 0.98 * all);
    }
  }
}

TEST_CASE("joint_bilateral in mode mean takes the weighted mean of the definition") {
  const Settings s{3, 2, 12, "mean"};
  for_each_scene(s, 0.3, [&](const auto& map, const auto& pair, const auto& result) {
    for_each_pixel(map, pair, result, [&](int y, int x) {
      const double expected = mean(votes(s, map, pair.base, y, x));
      REQUIRE(std::abs(static_cast<double>(result.disparity(y, x)) - expected) < 0.05);
    });
  });
}

TEST_CASE("joint_bilateral with flat guide and wide weights is the median") {
  const DisparityMap map = xgm::testing::random_map({31, 22}, {-30, 9, 0.25, 0.2}, 8);
  const ImagePair flat{xgm::Image(cv::Mat1f(map.size(), 50.0F)), {}};
  const auto median = xgm::testing::stage<xgm::Filter>("{type: median, window: 5}");
  CHECK(identical(run({2, 1000, 10, "median"}, map, flat), median->run(map, flat, {})));
}

TEST_CASE("joint_bilateral moves a disparity edge onto the edge of the image") {
  const DisparityMap fattened = xgm::testing::drawn_map(
      {"1115555", "1115555", "1115555", "1115555", "1115555", "1115555", "1115555"});
  ImagePair pair{xgm::Image(cv::Mat1f(fattened.size(), 20.0F)), {}};
  pair.base.planes[0].colRange(4, 7) = 200.0F;
  for (const std::string mode : {"median", "mean"}) {
    const DisparityMap result = run({4, 4, 10, mode}, fattened, pair);
    CHECK(result.disparity(3, 4) == 5.0F);
    CHECK(result.disparity(3, 3) < (mode == "median" ? 1.1F : 3.0F));
  }
}

TEST_CASE("joint_bilateral: no-data pixels neither vote nor change") {
  DisparityMap map = xgm::testing::drawn_map({"111", "191", "111"});
  ImagePair pair{xgm::Image(cv::Mat1f(map.size(), 20.0F)), {}};
  pair.base.valid = cv::Mat1b(map.size(), 1);
  pair.base.valid(1, 1) = 0;
  pair.base.planes[0](1, 1) = std::nanf("");
  CHECK(identical(run({1, 1, 10, "median"}, map, pair), map));
  CHECK(identical(run({1, 1, 10, "mean"}, map, pair), map));
}

namespace {

/// Noise with all that vectors could stumble over: holes, no-data and NaN pixels, colours too far
/// apart to vote, huge and equal disparities, negative zeros.
std::pair<DisparityMap, ImagePair> awkward_scene(cv::Size size, int planes, double step) {
  xgm::Random random(static_cast<std::uint64_t>(size.width * 31 + planes));
  DisparityMap map = xgm::testing::random_map(size, {-8, 8, step, 0.25}, 11);
  ImagePair pair = xgm::testing::random_guide(size, planes, 12);
  pair.base.valid = xgm::testing::random_mask(size, 0.1, 13);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int kind = random.integer(0, 60);
      if (kind == 0) pair.base.planes.back()(y, x) = std::nanf("");
      if (kind == 1) pair.base.planes[0](y, x) = 255.0F;
      if (!map.has_disparity(y, x)) continue;
      if (kind < 6) map.set(y, x, kind % 2 == 0 ? -0.0F : 0.0F);
      if (kind == 6) map.set(y, x, std::numeric_limits<float>::max());
      if (kind == 7) map.set(y, x, std::numeric_limits<float>::lowest());
    }
  }
  return {map, pair};
}

}  // namespace

TEST_CASE("joint_bilateral gives the same bits with every SIMD target") {
  const std::vector<cv::Size> sizes{{1, 1}, {5, 3}, {19, 4}, {20, 7}, {37, 11}, {83, 40}};
  for (const Settings& s : {Settings{1, 1, 10, "median"}, Settings{2, 2, 10, "median"},
                            Settings{2, 2, 10, "mean"}, Settings{15, 5, 8, "median"},
                            Settings{15, 5, 8, "mean"}, Settings{3, 0.2, 0.1, "median"}}) {
    for (const cv::Size size : sizes) {
      for (const int planes : {1, 3}) {
        for (const double step : {4.0, 0.001}) {
          const auto [map, pair] = awkward_scene(size, planes, step);
          const xgm::SimdChoice scalar("scalar");
          const DisparityMap reference = run(s, map, pair);
          for (const std::string& target : xgm::simd_targets()) {
            CAPTURE(target);
            CAPTURE(size);
            const xgm::SimdChoice choice(target);
            CHECK(identical(run(s, map, pair), reference));
          }
        }
      }
    }
  }
}
