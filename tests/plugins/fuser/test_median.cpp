// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tests/plugins/maps.hpp"
#include "tests/support/support.hpp"

namespace xgm::testing {
namespace {

DisparityMap fused(const std::string& yaml, const Candidates& candidates) {
  return stage<Fuser>(yaml)->run(candidates, {}, Context{});
}

/// The disparities of a pixel that are there, of the candidate with the most others within
/// `tolerance` of it; of equal ones the first.
std::vector<double> naive_group(const Candidates& candidates, double tolerance, int y, int x) {
  std::vector<double> best;
  for (const DisparityMap& of : candidates.maps) {
    if (!of.has_disparity(y, x)) continue;
    std::vector<double> group;
    for (const DisparityMap& map : candidates.maps) {
      if (!map.has_disparity(y, x)) continue;
      const double d = map.disparity(y, x);
      if (std::abs(d - double{of.disparity(y, x)}) <= tolerance) group.push_back(d);
    }
    if (group.size() > best.size()) best = group;
  }
  std::sort(best.begin(), best.end());
  return best;
}

TEST_CASE("median is the lower median of the largest group of disparities that agree") {
  for (const std::size_t count : {1U, 2U, 3U, 5U}) {
    for (const int support : {1, 2, 4}) {
      CAPTURE(count);
      CAPTURE(support);
      Candidates candidates;
      for (std::size_t i = 0; i < count; ++i) {
        candidates.maps.push_back(random_map({31, 22}, {-3, 3, 0.25, 0.3}, 7 + i));
      }
      candidates.others.resize(count);
      const DisparityMap map = fused(
          "{type: median, tolerance: 0.5, support: " + std::to_string(support) + "}", candidates);
      for (int y = 0; y < map.size().height; ++y) {
        for (int x = 0; x < map.size().width; ++x) {
          const std::vector<double> group = naive_group(candidates, 0.5, y, x);
          if (group.empty()) {
            CHECK(map.at(y, x) == candidates.maps.front().at(y, x));
          } else if (group.size() < static_cast<std::size_t>(support)) {
            CHECK(map.at(y, x) == Status::mismatched);
          } else {
            CHECK(map.disparity(y, x) == group[(group.size() - 1) / 2]);
          }
        }
      }
    }
  }
}

TEST_CASE("median outvotes a single matcher that is wrong") {
  const Candidates candidates{{drawn_map({"1515"}), drawn_map({"1911"}), drawn_map({"1.15"})},
                              {{}, {}, {}}};
  CHECK(identical(fused("{type: median}", candidates), drawn_map({"1515"})));
}

}  // namespace
}  // namespace xgm::testing
