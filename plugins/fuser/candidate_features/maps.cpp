// SPDX-License-Identifier: Apache-2.0
#include "plugins/fuser/candidate_features/maps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "plugins/fuser/candidate_choice/choice.hpp"

namespace xgm::fuser {
namespace {

/// Each pixel searches the two whole disparities that its own lies between.
DisparityRange around(const DisparityMap& map) {
  return DisparityRange::of_pixels(map.size(), [&](int y, int x) {
    if (!map.has_disparity(y, x)) return Interval{};
    const int below = static_cast<int>(std::floor(map.disparity(y, x)));
    return Interval{below, below + 2};
  });
}

/// Between the cells of both; one that cannot match is left out.
int between(const std::uint8_t* cells, float fraction, int bound) {
  const bool has_below = cells[0] != CostVolume::kNoMatch;
  const bool has_above = cells[1] != CostVolume::kNoMatch;
  if (!has_below && !has_above) return kNoCost;
  const float below = has_below ? cells[0] : cells[1], above = has_above ? cells[1] : cells[0];
  const float cost = below + (above - below) * fraction;
  return static_cast<int>(cost * 254 / static_cast<float>(std::max(bound, 1)) + 0.5F);
}

cv::Mat1b costs_of(const CostVolume& volume, const DisparityMap& map) {
  cv::Mat1b costs(map.size(), static_cast<std::uint8_t>(kNoCost));
  parallel_for(0, map.size().height, [&](int y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (volume.shape().count(y, x) == 0) continue;
      const float d = map.disparity(y, x);
      const float fraction = d - static_cast<float>(volume.shape().begin(y, x));
      costs(y, x) = static_cast<std::uint8_t>(between(volume.at(y, x), fraction, volume.max_cost));
    }
  });
  return costs;
}

/// In whole steps to the eight neighbours, 255 at most.
cv::Mat1b distance_to_hole(const DisparityMap& map) {
  const cv::Mat1b matched(map.status == static_cast<int>(Status::matched));
  if (cv::countNonZero(matched) == static_cast<int>(matched.total())) {
    return {map.size(), static_cast<std::uint8_t>(255)};
  }
  cv::Mat1f steps;
  cv::distanceTransform(matched, steps, cv::DIST_C, 3);
  cv::Mat1b distance;
  steps.convertTo(distance, CV_8U);
  return distance;
}

}  // namespace

CandidateMaps::CandidateMaps(const Candidates& all, const ImagePair& images,
                             const SlotList<Cost>& slots, const Context& context)
    : candidates(all),
      pair(images),
      costs_per_matcher(static_cast<int>(slots.size())),
      agreed(images.size(), std::numeric_limits<float>::quiet_NaN()),
      grey(images.base.grey()) {
  for (const DisparityMap& map : candidates.maps) {
    const auto shape = std::make_shared<const VolumeShape>(around(map), pair.base.valid);
    for (const Slot<Cost>& slot : slots) {
      costs.push_back(costs_of(slot(context, pair, shape), map));
    }
    hole_distance.push_back(distance_to_hole(map));
  }
  parallel_for(0, agreed.rows, [&](int y) {
    for (int x = 0; x < agreed.cols; ++x) {
      const int first = first_with_disparity(candidates, y, x);
      if (first == kNone || disputed(y, x)) continue;
      agreed(y, x) = candidates.maps[static_cast<std::size_t>(first)].disparity(y, x);
    }
  });
}

bool CandidateMaps::disputed(int y, int x) const {
  float lowest = std::numeric_limits<float>::infinity(), highest = -lowest;
  for (const DisparityMap& map : candidates.maps) {
    if (!map.has_disparity(y, x)) continue;
    lowest = std::min(lowest, map.disparity(y, x));
    highest = std::max(highest, map.disparity(y, x));
  }
  return highest - lowest > kDispute;
}

Needs needs_of_maps(const Workload& load, int matchers, int costs) {
  const double kept = matchers * (costs + 1.0) + 2 * sizeof(float);
  constexpr double kVolume = VolumeShape::kGranule + sizeof(VolumeShape::Slice);
  return {.working = load.pixels() * (kept + kVolume), .updates = load.pixels() * matchers * costs};
}

}  // namespace xgm::fuser
