// SPDX-License-Identifier: Apache-2.0
#include "plugins/search_range/naive.hpp"

namespace xgm::testing::ranges {
namespace {

NaiveRule min_max(int window, int relaxation) {
  return [=](const DisparityMap& map, int y, int x) -> std::optional<NaiveProposal> {
    if (!map.has_disparity(y, x)) return std::nullopt;
    const auto values = naive_window(map, y, x, window);
    return NaiveProposal{values.front(), values.back(), double(relaxation)};
  };
}

TEST_CASE("min_max equals Eq. 7 written plainly") {
  check_everywhere("min_max", min_max(7, 4), 4);
  check_everywhere("{type: min_max, window: 1, relaxation: 0}", min_max(1, 0), 0);
  check_everywhere("{type: min_max, window: 15, relaxation: 2}", min_max(15, 2), 2);
}

TEST_CASE("min_max does not depend on the number of threads") {
  CHECK(same_for_any_thread_count("min_max"));
}

TEST_CASE("a flat coarse map leaves the doubled disparity and the relaxation to search") {
  DisparityMap coarse({5, 4});
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) coarse.set(y, x, -3.25F);
  }
  const auto limits = DisparityRange::uniform({9, 8}, {-100, 100});
  const auto range = stage<SearchRange>("min_max")->run(coarse, limits, Context{});
  CHECK(range.hull() == Interval{-7 - 4, -6 + 4 + 1});
}

TEST_CASE("disparities far beyond any image do not overflow") {
  DisparityMap coarse({1, 1});
  coarse.set(0, 0, 3e38F);
  const auto limits = DisparityRange::uniform({2, 2}, {0, 9});
  const auto range = stage<SearchRange>("min_max")->run(coarse, limits, Context{});
  CHECK(range.hull() == Interval{-4, 13});
}

}  // namespace
}  // namespace xgm::testing::ranges
