// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"

namespace xgm::testing {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

DisparityMap with_confidence(const std::string& row, const std::vector<float>& confidence) {
  DisparityMap map = drawn_map({row});
  map.confidence = cv::Mat1f(confidence, true).reshape(1, 1);
  return map;
}

TEST_CASE("most_confident takes the highest confidence of the candidates that have a disparity") {
  const Candidates candidates{{with_confidence("12.4.6", {0.5F, 0.2F, 1, kNone, 0, kNone}),
                               with_confidence("789.xx", {0.5F, 0.3F, 0, 1, 0, 1})},
                              {{}, {}}};
  const DisparityMap map = stage<Fuser>("{type: most_confident}")->run(candidates, {}, Context{});
  CHECK(identical(map, drawn_map({"1894.6"})));
  CHECK(map.confidence(0, 0) == 0.5F);
  CHECK(map.confidence(0, 1) == 0.3F);
  CHECK(map.confidence(0, 2) == 0);
  for (const int x : {3, 4, 5}) CHECK(std::isnan(map.confidence(0, x)));
}

TEST_CASE("most_confident prefers any confidence to none") {
  const Candidates candidates{{with_confidence("1", {kNone}), with_confidence("2", {0})}, {{}, {}}};
  const DisparityMap map = stage<Fuser>("{type: most_confident}")->run(candidates, {}, Context{});
  CHECK(map.disparity(0, 0) == 2);
}

TEST_CASE("most_confident names the matcher whose map has no confidence") {
  const Candidates candidates{{with_confidence("1", {1}), drawn_map({"2"})}, {{}, {}}};
  CHECK_THROWS_WITH_AS(
      stage<Fuser>("{type: most_confident}")->run(candidates, {}, Context{}),
      doctest::Contains("the map of matchers[1] has no confidence; give that matcher a stage"),
      Error);
}

}  // namespace
}  // namespace xgm::testing
