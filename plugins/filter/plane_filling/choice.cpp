// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/plane_filling/choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "xgm/base/parallel.hpp"

namespace xgm::plane_filling {
namespace {

constexpr float kLeastWeight = 0.05F;  // neighbours of different colour are not quite independent

class Paths {
 public:
  Paths(const Holes& holes, const CandidateLists& candidates, const std::vector<float>& costs,
        const DisparityMap& map, const Smoothness& smoothness)
      : holes_(holes), candidates_(candidates), costs_(costs), map_(map), smoothness_(smoothness) {}

  /// Path costs of all candidates, along the paths that come from step k.
  std::vector<float> from(std::size_t k) const {
    std::vector<float> path = costs_;
    const bool ascending = k < kDirections / 2;  // the hole before comes earlier
    const std::size_t count = holes_.at.size();
    for (std::size_t i = 0; i < count; ++i) continue_to(ascending ? i : count - 1 - i, k, path);
    return path;
  }

 private:
  void continue_to(std::size_t hole, std::size_t k, std::vector<float>& path) const {
    const std::span<const Candidate> candidates = candidates_.of(hole);
    if (candidates.empty()) return;
    const cv::Point before = holes_.at[hole] + kSteps[k];
    if (!cv::Rect({}, map_.size()).contains(before)) return;
    const float likeness = std::exp(-holes_.distance[hole][k] / smoothness_.sigma);
    const float weight = std::max(likeness, kLeastWeight);
    const float slope = weight * smoothness_.slope, jump = weight * smoothness_.jump;
    float* const to = path.data() + candidates_.begin[hole];
    const int number = holes_.number(before);
    if (number < 0) {
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        to[i] += std::min(slope * std::abs(candidates[i].disparity - map_.disparity(before)), jump);
      }
      return;
    }
    listen(static_cast<std::size_t>(number), path, slope, jump, candidates, to);
  }

  /// Adds what the path has cost at the hole before, and the change to each candidate.
  void listen(std::size_t before, const std::vector<float>& path, float slope, float jump,
              std::span<const Candidate> candidates, float* to) const {
    const std::span<const Candidate> others = candidates_.of(before);
    if (others.empty()) return;
    const float* const cost = path.data() + candidates_.begin[before];
    const float least = *std::min_element(cost, cost + others.size());
    std::array<float, kMostCandidates> best;
    best.fill(jump);  // from the least one, at most
    for (std::size_t j = 0; j < others.size(); ++j) {
      const float above = cost[j] - least;
      if (above >= jump) continue;  // a jump from the least one costs less
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const float change = slope * std::abs(candidates[i].disparity - others[j].disparity);
        best[i] = std::min(best[i], above + change);
      }
    }
    for (std::size_t i = 0; i < candidates.size(); ++i) to[i] += best[i];
  }

  const Holes& holes_;
  const CandidateLists& candidates_;
  const std::vector<float>& costs_;
  const DisparityMap& map_;
  const Smoothness& smoothness_;
};

}  // namespace

std::vector<std::size_t> choose(const Holes& holes, const CandidateLists& candidates,
                                const std::vector<float>& costs, const DisparityMap& map,
                                const Smoothness& smoothness) {
  const Paths paths(holes, candidates, costs, map, smoothness);
  std::array<std::vector<float>, kDirections> path;
  parallel_for(0, static_cast<int>(kDirections), [&](int k) {
    path[static_cast<std::size_t>(k)] = paths.from(static_cast<std::size_t>(k));
  });
  std::vector<std::size_t> chosen(holes.at.size(), 0);
  for (std::size_t hole = 0; hole < chosen.size(); ++hole) {
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = candidates.begin[hole]; i < candidates.begin[hole + 1]; ++i) {
      float sum = 0;
      for (const std::vector<float>& along : path) sum += along[i];
      if (sum >= least) continue;
      least = sum;
      chosen[hole] = i - candidates.begin[hole];
    }
  }
  return chosen;
}

}  // namespace xgm::plane_filling
