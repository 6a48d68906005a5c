// SPDX-License-Identifier: Apache-2.0
// P1 and P2 of all steps of a pass: a table per step, indexed by class, and the classes of pixels.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "plugins/aggregation/path_engine/pixel_step.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/stage/penalty.hpp"

namespace xgm::aggregation {

/// The classes of pixels for all steps of a pass. If no step has more than two classes, which is
/// the common case, one byte per pixel holds the classes of all steps, step t in bit t. Otherwise
/// each step has a plane of bytes.
class PixelClasses {
 public:
  static constexpr int kMaxPacked = 8;  ///< steps

  /// `classes` is the largest number of classes that a step has.
  PixelClasses(int classes, int steps, int rows, int width);

  int count() const { return classes_; }
  bool packed() const { return packed_; }
  int plane_stride() const { return stride_; }
  std::ptrdiff_t row_stride() const {
    return bytes_.empty() ? 0 : static_cast<std::ptrdiff_t>(bytes_.step1());
  }
  /// Sets all classes of the slot to 0. Must precede add().
  void clear(int slot);
  /// Sets the classes of a step for pixels first, first + 1, ... Pixels that do not exist are
  /// skipped.
  void add(int step, int slot, int first, std::span<const std::uint8_t> classes);
  const std::uint8_t* at(int slot, int x) const { return bytes_[slot] + x; }
  int get(int step, const std::uint8_t* pixel) const {
    return packed_ ? *pixel >> step & 1 : pixel[step * stride_];
  }

 private:
  int classes_, stride_;
  bool packed_;
  cv::Mat1b bytes_;  // a row per slot: planes of pixels. Empty if there is one class
};

/// Penalties of a pass. Holds the classes of `rows` image rows at a time, in slots that load()
/// fills. Different slots may be used from different threads.
template <class Cell>
class PassPenalties {
 public:
  /// Penalties are multiplied by `unit`. `width` is the width of the image; `hull` contains all
  /// disparities that are searched.
  PassPenalties(const PenaltyField& field, std::vector<Direction> steps, int rows, int width,
                Interval hull, int unit);

  /// Fills a slot with the classes of image row y. Does nothing if there is one class only.
  void load(int slot, int y);

  bool same_everywhere() const { return base_.count() == 1 && match_.count() == 1; }
  const PixelClasses& base() const { return base_; }
  /// Classes of match pixels, stored from right to left, so that those of ascending disparities lie
  /// side by side.
  const PixelClasses& match() const { return match_; }
  /// Class of the match pixel that disparity 0 has at pixel x. The classes of higher disparities
  /// follow it; those of the pixels to the right of x lie before it. If the match pixel lies
  /// outside the image, its disparity cannot be matched, and the class does not matter.
  const std::uint8_t* match_at(int slot, int x) const {
    return match_.at(slot, 0) + (width_ - 1 - x - hull_.begin);
  }
  /// Penalties of a pixel: for each step, those of all match classes. `classes` are its packed base
  /// classes, 0 if there is one class. Looked up for all steps at once and without a branch:
  /// classes change from pixel to pixel in a way that processors do not foresee.
  const StepPenalties* of(int classes) const {
    return by_classes_.data() + static_cast<std::size_t>(classes) * row_;
  }
  /// The same where base classes are not packed: written to `row`, row_size() elements.
  void look_up(const std::uint8_t* base_classes, StepPenalties* row) const;
  std::size_t row_size() const { return row_; }

 private:
  static std::vector<PenaltyTable> tables_of(const PenaltyField& field,
                                             const std::vector<Direction>& steps);
  PassPenalties(const PenaltyField& field, std::vector<Direction> steps,
                const std::vector<PenaltyTable>& tables, int rows, int width, Interval hull,
                int unit);

  const PenaltyField& field_;
  std::vector<Direction> steps_;
  int width_;
  Interval hull_;
  PixelClasses base_, match_;
  std::vector<StepPenalties> penalties_;   // steps x base classes x match classes
  std::size_t row_;                        // steps x match classes
  std::vector<StepPenalties> by_classes_;  // a row for each combination of packed base classes
};

extern template class PassPenalties<std::uint8_t>;
extern template class PassPenalties<std::uint16_t>;

}  // namespace xgm::aggregation
