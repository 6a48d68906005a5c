// SPDX-License-Identifier: Apache-2.0
#include "plugins/fusion/k_medians/clusters.hpp"

#include <algorithm>
#include <limits>

namespace xgm::geo {
namespace {

/// Sums of distances to the median of any stretch of sorted values.
class Costs {
 public:
  explicit Costs(std::span<const float> sorted) : values_(sorted), sums_(sorted.size() + 1) {
    for (std::size_t i = 0; i < sorted.size(); ++i) sums_[i + 1] = sums_[i] + double{sorted[i]};
  }
  double operator()(std::size_t begin, std::size_t end) const {
    const std::size_t middle = begin + (end - begin) / 2;
    const double median = double{values_[middle]};
    return median * static_cast<double>(middle - begin) - (sums_[middle] - sums_[begin]) +
           (sums_[end] - sums_[middle]) - median * static_cast<double>(end - middle);
  }

 private:
  std::span<const float> values_;
  std::vector<double> sums_;
};

}  // namespace

float median_of(std::span<const float> sorted, const Cluster& cluster) {
  const std::size_t middle = cluster.begin + cluster.size() / 2;
  if (cluster.size() % 2 != 0) return sorted[middle];
  return (sorted[middle - 1] + sorted[middle]) / 2;
}

std::vector<Cluster> k_medians(std::span<const float> sorted, std::size_t k) {
  const std::size_t n = sorted.size();
  k = std::min(k, n);
  const Costs costs(sorted);
  // best[c][j]: of the first j values in c clusters; last[c][j]: where the last of these begins.
  std::vector<std::vector<double>> best(
      k + 1, std::vector<double>(n + 1, std::numeric_limits<double>::infinity()));
  std::vector<std::vector<std::size_t>> last(k + 1, std::vector<std::size_t>(n + 1));
  best[0][0] = 0;
  for (std::size_t c = 1; c <= k; ++c) {
    for (std::size_t j = c; j <= n; ++j) {
      for (std::size_t i = c - 1; i < j; ++i) {
        const double sum = best[c - 1][i] + costs(i, j);
        if (sum < best[c][j]) {
          best[c][j] = sum;
          last[c][j] = i;
        }
      }
    }
  }
  std::vector<Cluster> clusters(k);
  std::size_t end = n;
  for (std::size_t c = k; c > 0; --c) {
    clusters[c - 1] = {last[c][end], end};
    end = last[c][end];
  }
  return clusters;
}

}  // namespace xgm::geo
