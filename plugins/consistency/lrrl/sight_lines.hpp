// SPDX-License-Identifier: Apache-2.0
// Where the disparities of a row point in the other view's row.
#pragma once

#include <cstdint>
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
  /// Of pixel 0; NaN where there is none.
  const float* disparities() const { return disparities_.data() + 1; }
  /// Pixel of the other view nearest to x - disparity of x, halves to the right; -1 or width()
  /// where it is none, or the pixel has no disparity.
  const int* targets() const { return targets_.data(); }
  /// 1 where the line of sight through pixel x of the other view meets the disparity function of
  /// this one: q's target is x for some pixel q, or x lies between the targets of q and q + 1 where
  /// both belong to one surface. Else 0.
  const std::uint8_t* met() const { return met_.data() + 1; }

 private:
  std::vector<float> disparities_;
  std::vector<int> targets_;
  std::vector<std::uint8_t> met_;
};

/// Writes a row that is checked against the other view's: disparities that agree, to `threshold`,
/// with those of the pixels that they point at stay, with their states; the others become NaN,
/// mismatched where other lines of sight meet, else occluded. Pixels without one keep their states.
/// The formula x_other = x - d holds for both views, so one function serves both.
void check(const SightLines& row, const SightLines& other, double threshold,
           const std::uint8_t* states, float* disparities, std::uint8_t* reasons);

}  // namespace xgm::lrrl
