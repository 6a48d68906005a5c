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
    if (!map.has_disparity(y, x)) return std::nullopt;
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

/// Compares some pixels only: sorting every large window would take minutes.
int wrong_of_some(const DisparityMap& coarse, int window) {
  const std::string yaml = "{type: percentile, window: " + std::to_string(window) + "}";
  const cv::Size fine = coarse.size() * 2;
  const auto limits = DisparityRange::uniform(fine, {-20000, 20000});
  const auto range = stage<SearchRange>(yaml)->run(coarse, limits, Context{});
  const auto rule = percentile(window, 5, 95, 4);
  int wrong = 0;
  for (int y = 0; y < fine.height; y += 37) {
    for (int x = 0; x < fine.width; x += 19) {
      const auto expected = naive_interval(rule(coarse, y / 2, x / 2), limits.at(y, x), 4);
      wrong += !(range.at(y, x) == expected);
    }
  }
  return wrong;
}

TEST_CASE("percentile is exact in maps wider than a strip of column histograms") {
  const auto coarse = random_coarse_map({300, 40}, -100, 200, 0.2, 9);
  CHECK(wrong_of_some(coarse, 41) == 0);
  CHECK(wrong_of_some(coarse, 255) == 0);
}

TEST_CASE("percentile is exact where disparities are too many for column histograms") {
  DisparityMap coarse({180, 150});
  for (int i = 0; i < 180 * 150; ++i) {  // a permutation: each disparity once
    coarse.set(i / 180, i % 180, static_cast<float>(i * 7919 % (180 * 150)) / 4);
  }
  CHECK(wrong_of_some(coarse, 255) == 0);
}

TEST_CASE("percentile is exact where disparities lie too far apart for a table") {
  DisparityMap coarse = random_coarse_map({40, 30}, -100, 200, 0.2, 9);
  coarse.set(0, 0, 3e38F);
  coarse.set(7, 9, -3e38F);
  CHECK(wrong_of_some(coarse, 9) == 0);
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
