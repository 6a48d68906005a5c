// SPDX-License-Identifier: Apache-2.0
// Where the disparities of a row point in the other view's row.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace xgm::lrrl {

/// One row of a view. Pixels -1 and width() exist and have no disparity: what points outside of the
/// other view points at them.
class SightLines {
 public:
  explicit SightLines(int width);

  /// Takes a row. Whether another one's lines meet here is judged by their steps: between two
  /// neighbours whose disparities differ by at most `step` there is a surface.
  void load(const float* disparities, double step);

  int width() const { return static_cast<int>(targets_.size()); }
  /// Disparity of pixel x, NaN where there is none.
  float disparity(int x) const { return disparities_[index(x)]; }
  /// Pixel of the other view nearest to x - disparity(x), halves to the right; -1 or width() where
  /// it is none, or the pixel has no disparity.
  int target(int x) const { return targets_[static_cast<std::size_t>(x)]; }
  /// Whether the line of sight through pixel x of the other view meets the disparity function of
  /// this one: target(q) = x for some pixel q, or x lies between the targets of q and q + 1 where
  /// both belong to one surface.
  bool meet(int x) const { return met_[index(x)] != 0; }

 private:
  static std::size_t index(int x) { return static_cast<std::size_t>(x + 1); }

  std::vector<float> disparities_;
  std::vector<int> targets_;
  std::vector<std::uint8_t> met_;
};

}  // namespace xgm::lrrl
