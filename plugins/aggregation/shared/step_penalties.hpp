// SPDX-License-Identifier: Apache-2.0
// P1 and P2 of one step direction, looked up by pixel or by cell.
#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "plugins/aggregation/shared/step.hpp"
#include "xgm/stage/penalty.hpp"

namespace xgm::aggregation {

/// Holds the classes of as many image rows as the caller needs at a time: `rows` slots, filled by
/// load(). Different slots may be used from different threads.
template <class Cell>
class StepPenalties {
 public:
  /// Penalties are multiplied by `unit`. `width` is the image's.
  StepPenalties(const PenaltyField& field, Direction step, int rows, int width, Cell unit);

  /// Fetches the classes of image row y. Does nothing if there is one class only.
  void load(int slot, int y);

  /// Whether all disparities of a pixel have the same penalties.
  bool same_for_all_disparities() const { return match_classes_ == 1; }
  /// Their penalties, if so.
  SamePenalties<Cell> of_pixel(int slot, int x) const { return {p1(slot, x)[0], p2(slot, x)[0]}; }
  /// Writes the penalties of pixel x for disparities [begin, begin + count).
  void of_cells(int slot, int x, int begin, int count, Cell* p1, Cell* p2) const;

 private:
  /// Penalties of the pixel's class, one per match class.
  const Cell* p1(int slot, int x) const { return p1_.data() + row_of_table(slot, x); }
  const Cell* p2(int slot, int x) const { return p2_.data() + row_of_table(slot, x); }
  std::size_t row_of_table(int slot, int x) const {
    return base_.empty() ? 0 : static_cast<std::size_t>(base_(slot, x) * match_classes_);
  }

  const PenaltyField& field_;
  Direction step_;
  int width_;
  int match_classes_;
  std::vector<Cell> p1_, p2_;  // base_classes x match_classes
  cv::Mat1b base_;             // slot, x; empty if there is one class
  // slot, width - 1 - x: from right to left, so that the match pixels x - d of ascending d lie
  // side by side. Empty if there is one class.
  cv::Mat1b match_;
};

extern template class StepPenalties<std::uint8_t>;
extern template class StepPenalties<std::uint16_t>;

}  // namespace xgm::aggregation
