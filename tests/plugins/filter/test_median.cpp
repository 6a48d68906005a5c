// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>

#include "tests/plugins/maps.hpp"
#include "tests/support/simd.hpp"
#include "tests/support/support.hpp"
#include "xgm/plugin.hpp"

using xgm::DisparityMap;
using xgm::testing::identical;

namespace {

DisparityMap run(int window, const DisparityMap& map) {
  const std::string yaml = "{type: median, window: " + std::to_string(window) + "}";
  return xgm::testing::stage<xgm::Filter>(yaml)->run(map, {}, xgm::Context{});
}

DisparityMap oracle(int window, const DisparityMap& map) {
  DisparityMap result = map.clone();
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (!map.has_disparity(y, x)) continue;
      std::vector<float> values;
      for (int v = 0; v < map.size().height; ++v) {
        for (int u = 0; u < map.size().width; ++u) {
          const bool inside = std::abs(u - x) <= window / 2 && std::abs(v - y) <= window / 2;
          if (inside && map.has_disparity(v, u)) values.push_back(map.disparity(v, u));
        }
      }
      std::sort(values.begin(), values.end());
      result.disparity(y, x) = values[(values.size() - 1) / 2];
    }
  }
  return result;
}

}  // namespace

TEST_CASE("median is the lower middle of the disparities in the window") {
  for (const cv::Size size : xgm::testing::kMapSizes) {
    for (const int window : {3, 5, 9, 31}) {
      for (const double invalid : {0.0, 0.3, 0.9, 1.0}) {
        CAPTURE(size);
        CAPTURE(window);
        const DisparityMap map = xgm::testing::random_map(size, {-30, 9, 0.25, invalid}, 5);
        const DisparityMap expected = oracle(window, map);
        xgm::testing::with_each_simd_target([&] { CHECK(identical(run(window, map), expected)); });
      }
    }
  }
}

TEST_CASE("median removes single outliers and keeps straight edges") {
  const DisparityMap map = xgm::testing::drawn_map({"1115555", "1915555", "1115505", "1115555"});
  const DisparityMap clean = xgm::testing::drawn_map({"1115555", "1115555", "1115555", "1115555"});
  CHECK(identical(run(3, map), clean));
  CHECK(identical(run(3, clean), clean));
}

TEST_CASE("median fills nothing and leaves its input alone") {
  const DisparityMap map = xgm::testing::drawn_map({"1.x", "#?2", "3.."});
  const DisparityMap before = map.clone();
  const DisparityMap result = run(3, map);
  CHECK(cv::countNonZero(result.status != map.status) == 0);
  CHECK(identical(map, before));
}
