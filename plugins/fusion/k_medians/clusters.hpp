// SPDX-License-Identifier: Apache-2.0
// Numbers on a line in groups around their medians.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace xgm::geo {

/// Elements [begin, end) of sorted values.
struct Cluster {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t size() const { return end - begin; }
};

/// The median of a cluster; half the sum of the two in the middle, if there are two.
float median_of(std::span<const float> sorted, const Cluster& cluster);

/// The `k` clusters, at most as many as there are values, whose distances to their medians have the
/// smallest sum; ascending. Not the local optimum that k-medians iterations end in, but the best of
/// all: clusters on a line are stretches of the sorted values, so that dynamic programming finds
/// them (Wang, Song: Ckmeans.1d.dp, R Journal 3(2), 2011, for medians).
std::vector<Cluster> k_medians(std::span<const float> sorted, std::size_t k);

}  // namespace xgm::geo
