// SPDX-License-Identifier: Apache-2.0
#include "plugins/search_range/naive.hpp"

namespace xgm::testing::ranges {
namespace {

std::optional<double> naive_mean(const DisparityMap& map) {
  const int everywhere = 2 * std::max(map.size().width, map.size().height) + 1;
  const auto values = naive_window(map, 0, 0, everywhere);
  if (values.empty()) return std::nullopt;
  double sum = 0;
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (map.has_disparity(y, x)) sum += static_cast<double>(map.disparity(y, x));
    }
  }
  return sum / static_cast<double>(values.size());
}

NaiveRule median_window(int window, int relaxation, int median, int tau) {
  return [=](const DisparityMap& map, int y, int x) -> std::optional<NaiveProposal> {
    if (map.has_disparity(y, x)) {
      const auto values = naive_window(map, y, x, window);
      return NaiveProposal{values.front(), values.back(), double(relaxation)};
    }
    const auto values = naive_window(map, y, x, median);
    if (!values.empty()) {
      const double m = values[(values.size() - 1) / 2];
      return NaiveProposal{m, m, double(tau)};
    }
    const auto mean = naive_mean(map);
    if (!mean) return std::nullopt;
    return NaiveProposal{*mean, *mean, double(tau)};
  };
}

TEST_CASE("median_window equals Rothermel's rules written plainly") {
  check_everywhere("median_window", median_window(7, 4, 31, 16), 4);
  check_everywhere("{type: median_window, window: 3, relaxation: 1, median_window: 5, tau: 3}",
                   median_window(3, 1, 5, 3), 1);
}

TEST_CASE("a hole far from any disparity searches around the mean of the map") {
  DisparityMap coarse({60, 1});
  coarse.set(0, 0, 10.F);
  coarse.set(0, 1, 13.F);
  const auto limits = DisparityRange::uniform({120, 2}, {0, 100});
  const auto range = stage<SearchRange>("median_window")->run(coarse, limits, Context{});
  CHECK(range.at(0, 119) == Interval{23 - 16, 23 + 16 + 1});
  CHECK(range.at(0, 4) == Interval{20 - 16, 20 + 16 + 1});  // the lower of the two middle ones
}

TEST_CASE("median_window does not depend on the number of threads") {
  CHECK(same_for_any_thread_count("median_window"));
}

}  // namespace
}  // namespace xgm::testing::ranges
