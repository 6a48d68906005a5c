// SPDX-License-Identifier: Apache-2.0
// The votes of a window: disparities with weights, and their weighted median and mean.
#pragma once

#include <array>
#include <cstddef>

namespace xgm::joint_bilateral {

inline constexpr int kMaxRadius = 15;

/// Weights are whole numbers, so that their sums are exact whatever the order.
inline constexpr int kFullWeight = 65535;

/// Up to (2 kMaxRadius + 1)^2 votes, on the stack: the filter visits millions of windows.
class Votes {
 public:
  void clear() { size_ = 0; }
  void add(float value, int weight) { votes_[size_++] = {value, weight}; }
  bool empty() const { return size_ == 0; }

  /// The smallest value such that it and all smaller ones have at least half of the weight: always
  /// one of the values. Reorders the votes. There must be votes, all of positive weight.
  float weighted_median();
  double weighted_mean() const;

 private:
  struct Vote {
    float value;
    int weight;
  };

  static constexpr std::size_t kSide = 2 * kMaxRadius + 1;
  std::array<Vote, kSide * kSide> votes_;
  std::size_t size_ = 0;
};

}  // namespace xgm::joint_bilateral
