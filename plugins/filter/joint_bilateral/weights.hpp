// SPDX-License-Identifier: Apache-2.0
// Weights of the joint bilateral filter, from tables.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace xgm::joint_bilateral {

/// weight = exp(-(dx^2 + dy^2) / (2 sigma_space^2)) * exp(-c^2 / (2 sigma_range^2)), as a share of
/// kFullWeight, rounded to the nearest whole number. c is a colour distance in grey levels, rounded
/// to the nearest 1/kSteps.
class Weights {
 public:
  static constexpr int kSteps = 8;

  Weights(int radius, double sigma_space, double sigma_range);

  int radius() const { return radius_; }
  /// The spatial factors of row dy, for dx = -radius to radius.
  const float* space_row(int dy) const { return space_[dy + radius_] + radius_; }
  /// The factors of colour distances in steps of 1/kSteps; of larger distances it is zero.
  const std::vector<float>& range() const { return range_; }
  /// Zero for distances too large to count, or NaN.
  int operator()(float space, float colour_distance) const {
    const float step = colour_distance * kSteps + 0.5F;
    if (!(step < static_cast<float>(range_.size()))) return 0;
    return static_cast<int>(space * range_[static_cast<std::size_t>(step)] + 0.5F);
  }

 private:
  int radius_;
  cv::Mat1f space_;           // (2 radius + 1)^2, times kFullWeight
  std::vector<float> range_;  // by colour distance * kSteps, as far as a weight can be 1 or more
};

}  // namespace xgm::joint_bilateral
