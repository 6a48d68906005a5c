// SPDX-License-Identifier: Apache-2.0
// What the tests of the search_range plugins share: random coarse maps, and the paper's Eq. 7
// written plainly around any rule for one window.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "support/support.hpp"

namespace xgm::testing::ranges {

/// The closed interval of coarse disparities that a rule proposes for coarse pixel (y, x), and how
/// far it is relaxed, in fine pixels. Nothing: all of the limits.
struct NaiveProposal {
  double low, high, relaxation;
};
using NaiveRule = std::function<std::optional<NaiveProposal>(const DisparityMap&, int y, int x)>;

/// Random disparities, some whole, some halves, some thirds; `holes` is the share of pixels
/// without.
inline DisparityMap random_coarse_map(cv::Size size, double low, double high, double holes,
                                      std::uint64_t seed) {
  Random random(seed);
  DisparityMap map(size, Status::mismatched);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int steps = random.integer(1, 3);
      const double d = std::round(random.real(low, high) * steps) / steps;
      const auto why = static_cast<Status>(random.integer(2, kStatusCount - 1));
      if (random.real(0, 1) < holes) {
        map.invalidate(y, x, why);
      } else {
        map.set(y, x, static_cast<float>(d),
                random.integer(0, 3) == 0 ? Status::filled : Status::matched);
      }
    }
  }
  return map;
}

/// The disparities of the window around (y, x), in ascending order.
inline std::vector<double> naive_window(const DisparityMap& map, int y, int x, int window) {
  std::vector<double> values;
  for (int v = y - window / 2; v <= y + window / 2; ++v) {
    for (int u = x - window / 2; u <= x + window / 2; ++u) {
      if (v < 0 || u < 0 || v >= map.size().height || u >= map.size().width) continue;
      if (map.has_disparity(v, u)) values.push_back(static_cast<double>(map.disparity(v, u)));
    }
  }
  std::sort(values.begin(), values.end());
  return values;
}

/// Eq. 7 at one fine pixel: the proposal within the relaxed limits, or all of these.
inline Interval naive_interval(const std::optional<NaiveProposal>& proposal, Interval limits,
                               int relaxation) {
  if (limits.empty()) return {};
  const double lowest = limits.begin - relaxation;
  const double highest = limits.end - 1 + relaxation;
  double t_min = lowest;
  double t_max = highest;
  if (proposal) {
    t_min = std::max(lowest, std::floor(2 * proposal->low - proposal->relaxation));
    t_max = std::min(highest, std::ceil(2 * proposal->high + proposal->relaxation));
  }
  if (t_min > t_max) return {static_cast<int>(lowest), static_cast<int>(highest) + 1};
  return {static_cast<int>(t_min), static_cast<int>(t_max) + 1};
}

/// What the rule proposes for every coarse pixel, row by row.
using NaiveProposals = std::vector<std::optional<NaiveProposal>>;
inline NaiveProposals naive_proposals(const NaiveRule& rule, const DisparityMap& coarse) {
  NaiveProposals proposals;
  for (int y = 0; y < coarse.size().height; ++y) {
    for (int x = 0; x < coarse.size().width; ++x) proposals.push_back(rule(coarse, y, x));
  }
  return proposals;
}

/// How many pixels of a plugin's answer differ from the proposals.
inline int wrong_pixels(const SearchRange& plugin, const NaiveProposals& proposals,
                        const DisparityMap& coarse, const DisparityRange& limits, int relaxation) {
  const DisparityRange range = plugin.run(coarse, limits, Context{});
  REQUIRE(range.size() == limits.size());
  int wrong = 0;
  for (int y = 0; y < limits.size().height; ++y) {
    for (int x = 0; x < limits.size().width; ++x) {
      const auto i = static_cast<std::size_t>(y / 2 * coarse.size().width + x / 2);
      const Interval expected = naive_interval(proposals[i], limits.at(y, x), relaxation);
      const Interval found = range.at(y, x);
      wrong += expected.empty() ? !found.empty() : !(found == expected);
    }
  }
  return wrong;
}

/// Runs the rule and the plugin over sizes, shares of holes and limits of all sorts.
inline void check_everywhere(const std::string& yaml, const NaiveRule& rule, int relaxation) {
  const auto plugin = stage<SearchRange>(yaml);
  for (const cv::Size fine : {cv::Size(1, 1), {2, 2}, {3, 1}, {1, 17}, {26, 21}, {61, 44}}) {
    const cv::Size coarse_size((fine.width + 1) / 2, (fine.height + 1) / 2);
    for (const double holes : {0.0, 0.4, 0.95, 1.0}) {
      const auto seed = static_cast<std::uint64_t>(fine.width * 10 + int(holes * 10));
      INFO(yaml, " fine ", fine.width, "x", fine.height, " holes ", holes);
      const auto coarse = random_coarse_map(coarse_size, -20, 13, holes, seed);
      const auto proposals = naive_proposals(rule, coarse);
      for (const Interval hull : {Interval{-45, 30}, {-3, 7}, {5, 6}, {200, 300}, {0, 0}}) {
        const auto uniform = DisparityRange::uniform(fine, hull);
        CHECK(wrong_pixels(*plugin, proposals, coarse, uniform, relaxation) == 0);
        if (hull.empty()) continue;
        const auto map = random_range(fine, hull, seed + 1);
        CHECK(wrong_pixels(*plugin, proposals, coarse, map, relaxation) == 0);
      }
    }
  }
}

inline bool same_for_any_thread_count(const std::string& yaml) {
  const auto plugin = stage<SearchRange>(yaml);
  const auto coarse = random_coarse_map({40, 33}, -20, 13, 0.4, 7);
  const auto limits = random_range({79, 66}, {-45, 30}, 8);
  std::optional<DisparityRange> first;
  for (const int count : {1, 2, 3, 8}) {
    const xgm::ThreadLimit threads(count);
    const DisparityRange range = plugin->run(coarse, limits, Context{});
    if (!first) first = range;
    for (int y = 0; y < 66; ++y) {
      for (int x = 0; x < 79; ++x) {
        if (!(range.at(y, x) == first->at(y, x))) return false;
      }
    }
  }
  return true;
}

}  // namespace xgm::testing::ranges
