// SPDX-License-Identifier: Apache-2.0
// P1 and P2 of all steps of a pass: tables by class, and the classes of the pixels.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "plugins/aggregation/path_engine/pixel_step.hpp"
#include "xgm/data/disparity_range.hpp"
#include "xgm/stage/penalty.hpp"

namespace xgm::aggregation {

/// The classes that all steps of a pass give to pixels. Where there are two per step, as most
/// penalties have, a byte holds those of all steps, step t's in bit t. Else each step has a plane
/// of bytes.
class PixelClasses {
 public:
  static constexpr int kMaxPacked = 8;  ///< steps

  /// `classes` is the largest number of any step.
  PixelClasses(int classes, int steps, int rows, int width);

  int count() const { return classes_; }
  bool packed() const { return packed_; }
  int plane_stride() const { return stride_; }
  std::ptrdiff_t row_stride() const {
    return bytes_.empty() ? 0 : static_cast<std::ptrdiff_t>(bytes_.step1());
  }
  /// All classes of the slot become 0, for add() to begin with.
  void clear(int slot);
  /// The classes that a step gives to pixels first, first + 1...; those that do not exist are left.
  void add(int step, int slot, int first, std::span<const std::uint8_t> classes);
  const std::uint8_t* at(int slot, int x) const { return bytes_[slot] + x; }
  int get(int step, const std::uint8_t* pixel) const {
    return packed_ ? *pixel >> step & 1 : pixel[step * stride_];
  }

 private:
  int classes_, stride_;
  bool packed_;
  cv::Mat1b bytes_;  // slot; planes, of x each. Empty if there is one class
};

/// Holds the classes of as many image rows as the caller needs at a time: `rows` slots, filled by
/// load(). Different slots may be used from different threads.
template <class Cell>
class PassPenalties {
 public:
  /// Penalties are multiplied by `unit`. `width` is the image's, `hull` holds all disparities that
  /// are asked for.
  PassPenalties(const PenaltyField& field, std::vector<Direction> steps, int rows, int width,
                Interval hull, int unit);

  /// Fetches the classes of image row y. Does nothing if there is one class only.
  void load(int slot, int y);

  bool same_everywhere() const { return base_.count() == 1 && match_.count() == 1; }
  const PixelClasses& base() const { return base_; }
  /// The match pixels from right to left, so that those of ascending disparities lie side by side.
  const PixelClasses& match() const { return match_; }
  /// Class of the match pixel of disparity 0 at pixel x; those of the next disparities follow,
  /// those of the next pixels lie before it. Where the match pixel lies outside the image nothing
  /// can be matched, and any class will do.
  const std::uint8_t* match_at(int slot, int x) const {
    return match_.at(slot, 0) + (width_ - 1 - x - hull_.begin);
  }
  /// Tables of all steps: base classes x match classes each.
  const StepPenalties* tables() const { return penalties_.data(); }

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
  std::vector<StepPenalties> penalties_;  // steps x base classes x match classes
};

extern template class PassPenalties<std::uint8_t>;
extern template class PassPenalties<std::uint16_t>;

}  // namespace xgm::aggregation
