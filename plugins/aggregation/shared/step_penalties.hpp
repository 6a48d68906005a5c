// SPDX-License-Identifier: Apache-2.0
// P1 and P2 of one step direction: a table by match class for each pixel, and the classes.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "xgm/data/disparity_range.hpp"
#include "xgm/stage/penalty.hpp"

namespace xgm::aggregation {

/// Holds the classes of as many image rows as the caller needs at a time: `rows` slots, filled by
/// load(). Different slots may be used from different threads.
template <class Cell>
class StepPenalties {
 public:
  /// Penalties are multiplied by `unit`. `width` is the image's, `hull` holds all disparities that
  /// are asked for.
  StepPenalties(const PenaltyField& field, Direction step, int rows, int width, Interval hull,
                int unit);

  /// Fetches the classes of image row y. Does nothing if there is one class only.
  void load(int slot, int y);

  int match_classes() const { return match_classes_; }
  bool same_everywhere() const { return one_base_class_ && match_classes_ == 1; }
  /// Penalties at pixel x, one per match class.
  const Cell* p1(int slot, int x) const { return p1_.data() + row_of_table(slot, x); }
  const Cell* p2(int slot, int x) const { return p2_.data() + row_of_table(slot, x); }
  /// Match classes of disparities begin, begin + 1, ... at pixel x. Where the match pixel lies
  /// outside the image nothing can be matched, and any class will do. Only if there are several.
  const std::uint8_t* classes(int slot, int x, int begin) const {
    return match_[slot] + (width_ - 1 - x + begin - hull_.begin);
  }

 private:
  std::size_t row_of_table(int slot, int x) const {
    return one_base_class_ ? 0 : static_cast<std::size_t>(base_(slot, x) * match_classes_);
  }

  const PenaltyField& field_;
  Direction step_;
  int width_;
  Interval hull_;
  bool one_base_class_;
  int match_classes_;
  std::vector<Cell> p1_, p2_;  // base_classes x match_classes
  cv::Mat1b base_;             // slot, x; empty if there is one class
  // slot, width - 1 - x - hull.begin: from right to left, so that the match pixels x - d of
  // ascending d lie side by side. Empty if there is one class.
  cv::Mat1b match_;
};

extern template class StepPenalties<std::uint8_t>;
extern template class StepPenalties<std::uint16_t>;

}  // namespace xgm::aggregation
