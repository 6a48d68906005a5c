// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/plane_filling/choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "xgm/base/parallel.hpp"

namespace xgm::plane_filling {
namespace {

/// Steps of the paths that come from above or from the left; the others are the opposite ones.
const std::array<cv::Point, 4> kForward{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}}};
constexpr float kLeastWeight = 0.05F;  // neighbours of different colour are not quite independent

class Paths {
 public:
  Paths(const Holes& holes, const std::vector<float>& costs, const DisparityMap& map,
        const Image& image, const Smoothness& smoothness)
      : holes_(holes), costs_(costs), map_(map), image_(image), smoothness_(smoothness) {}

  /// Path costs along `step`, of all candidates.
  std::vector<float> along(cv::Point step) const {
    std::vector<float> path = costs_;
    const std::size_t count = holes_.at.size();
    const bool forward = step.y > 0 || (step.y == 0 && step.x > 0);
    for (std::size_t i = 0; i < count; ++i) continue_to(forward ? i : count - 1 - i, step, path);
    return path;
  }

 private:
  void continue_to(std::size_t hole, cv::Point step, std::vector<float>& path) const {
    const cv::Point here = holes_.at[hole], before = here - step;
    if (!cv::Rect({}, map_.size()).contains(before)) return;
    if (!image_.is_valid(before.y, before.x)) return;
    const float likeness = std::exp(-colour_distance(image_, here, before) / smoothness_.sigma);
    const float weight = std::max(likeness, kLeastWeight);
    const std::span<const Candidate> candidates = holes_.of(hole);
    float* const to = path.data() + holes_.begin[hole];
    if (map_.has_disparity(before.y, before.x)) {
      for (std::size_t k = 0; k < candidates.size(); ++k) {
        to[k] += weight * penalty(candidates[k].disparity, map_.disparity(before));
      }
      return;
    }
    const int number = holes_.number(before);
    if (number < 0) return;
    const auto from = static_cast<std::size_t>(number);
    const std::span<const Candidate> others = holes_.of(from);
    if (others.empty()) return;
    const float* const cost = path.data() + holes_.begin[from];
    const float least = *std::min_element(cost, cost + others.size());
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      float best = weight * smoothness_.jump;  // from the least one, at most
      for (std::size_t l = 0; l < others.size(); ++l) {
        const float change = weight * penalty(candidates[k].disparity, others[l].disparity);
        best = std::min(best, cost[l] - least + change);
      }
      to[k] += best;
    }
  }

  float penalty(float a, float b) const {
    return std::min(smoothness_.slope * std::abs(a - b), smoothness_.jump);
  }

  const Holes& holes_;
  const std::vector<float>& costs_;
  const DisparityMap& map_;
  const Image& image_;
  const Smoothness& smoothness_;
};

void add(const std::vector<float>& more, std::vector<float>& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
}

}  // namespace

std::vector<std::size_t> choose(const Holes& holes, const std::vector<float>& costs,
                                const DisparityMap& map, const Image& image,
                                const Smoothness& smoothness) {
  const Paths paths(holes, costs, map, image, smoothness);
  // One sum for each of both ways, so that the order of additions is the same on any number of
  // threads.
  std::array<std::vector<float>, 2> sums;
  parallel_for(0, 2, [&](int way) {
    std::vector<float>& sum = sums[static_cast<std::size_t>(way)];
    sum.assign(costs.size(), 0.0F);
    for (const cv::Point step : kForward) add(paths.along(way == 0 ? step : -step), sum);
  });
  add(sums[1], sums[0]);
  std::vector<std::size_t> chosen(holes.at.size(), 0);
  for (std::size_t hole = 0; hole < chosen.size(); ++hole) {
    const auto first = sums[0].begin() + static_cast<std::ptrdiff_t>(holes.begin[hole]);
    const auto last = sums[0].begin() + static_cast<std::ptrdiff_t>(holes.begin[hole + 1]);
    if (first != last)
      chosen[hole] = static_cast<std::size_t>(std::min_element(first, last) - first);
  }
  return chosen;
}

}  // namespace xgm::plane_filling
