// SPDX-License-Identifier: Apache-2.0
#include "plugins/search_range/naive.hpp"

namespace xgm::testing::ranges {
namespace {

double nearest_rank(const std::vector<double>& ascending, double percentile) {
  const double rank = std::ceil(percentile * static_cast<double>(ascending.size()) / 100);
  return ascending[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

NaiveRule percentile(int window, double low, double high, int relaxation) {
  return [=](const DisparityMap& map, int y, int x) -> std::optional<NaiveProposal> {
    if (!map.valid(y, x)) return std::nullopt;
    const auto values = naive_window(map, y, x, window);
    return NaiveProposal{nearest_rank(values, low), nearest_rank(values, high), double(relaxation)};
  };
}

TEST_CASE("percentile equals sorting every window") {
  check_everywhere("percentile", percentile(41, 5, 95, 4), 4);
  check_everywhere("{type: percentile, window: 9, low: 20, high: 70, relaxation: 0}",
                   percentile(9, 20, 70, 0), 0);
  check_everywhere("{type: percentile, window: 3, low: 50, high: 50, relaxation: 1}",
                   percentile(3, 50, 50, 1), 1);
}

TEST_CASE("percentiles 0 and 100 are min_max") {
  const auto ranks =
      stage<SearchRange>("{type: percentile, window: 7, low: 0, high: 100, relaxation: 4}");
  const auto extrema = stage<SearchRange>("{type: min_max, window: 7, relaxation: 4}");
  const auto coarse = random_coarse_map({31, 22}, 0, 60, 0.3, 5);
  const auto limits = DisparityRange::uniform({61, 44}, {0, 120});
  const auto a = ranks->run(coarse, limits, Context{});
  const auto b = extrema->run(coarse, limits, Context{});
  int different = 0;
  for (int y = 0; y < 44; ++y) {
    for (int x = 0; x < 61; ++x) different += !(a.at(y, x) == b.at(y, x));
  }
  CHECK(different == 0);
}

TEST_CASE("a few outliers in the window do not widen the search") {
  DisparityMap coarse({41, 41});
  for (int y = 0; y < 41; ++y) {
    for (int x = 0; x < 41; ++x) coarse.set(y, x, x < 2 ? 90.F : 10.F);  // 82 of 1681 pixels
  }
  const auto limits = DisparityRange::uniform({82, 82}, {0, 200});
  const auto range = stage<SearchRange>("percentile")->run(coarse, limits, Context{});
  CHECK(range.at(41, 41) == Interval{16, 25});
}

TEST_CASE("percentile does not depend on the number of threads") {
  CHECK(same_for_any_thread_count("percentile"));
}

TEST_CASE("percentile refuses a high percentile below the low one") {
  CHECK_THROWS_WITH_AS(stage<SearchRange>("{type: percentile, low: 60, high: 40}"),
                       doctest::Contains("must not be below low"), Error);
}

}  // namespace
}  // namespace xgm::testing::ranges
