// SPDX-License-Identifier: Apache-2.0
// Ragged volumes: each pixel has its own range of disparities. A dense volume is a special case.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "xgm/base/aligned_buffer.hpp"
#include "xgm/base/export.hpp"
#include "xgm/data/disparity_range.hpp"

namespace xgm {

/// Where the disparities of each pixel lie in a volume. Immutable; shared by all volumes of a
/// match. The cells of pixel (y, x) are [offset(y, x), offset(y, x) + count(y, x)); the first one
/// belongs to disparity begin(y, x). Pixels follow in row-major order. The slice of a pixel
/// occupies room(y, x) cells, so that kernels that handle kGranule cells at a time never touch
/// another slice. Cells of a slice beyond count(y, x) have no meaning.
class XGM_API VolumeShape {
 public:
  static constexpr int kGranule = 16;

  /// If `valid` is given, pixels where it is zero have no cells.
  explicit VolumeShape(const DisparityRange& range, const cv::Mat1b& valid = {});

  int width() const { return size_.width; }
  int height() const { return size_.height; }
  cv::Size size() const { return size_; }

  int begin(int y, int x) const { return slice(y, x).begin; }
  int end(int y, int x) const { return begin(y, x) + count(y, x); }
  int count(int y, int x) const { return slice(y, x).count; }
  /// count(y, x) rounded up to a multiple of kGranule.
  int room(int y, int x) const { return rounded_up(count(y, x)); }
  /// A multiple of kGranule.
  std::int64_t offset(int y, int x) const { return offset(y, slice(y, x)); }
  /// Sum of room(y, x): the number of cells that a volume allocates.
  std::int64_t cells() const { return row_.back(); }
  /// Largest number of disparities of a pixel.
  int max_count() const { return max_count_; }
  /// Smallest interval that contains the intervals of all pixels.
  Interval hull() const { return hull_; }
  std::size_t bytes() const;

  /// The layout of a pixel in one struct, for loops over many pixels.
  struct Slice {
    std::int32_t begin, count;
    std::uint32_t start;  ///< in granules, from the first granule of the row
  };
  const Slice& slice(int y, int x) const {
    return slices()[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                    static_cast<std::size_t>(x)];
  }
  std::int64_t offset(int y, const Slice& slice) const {
    return row_[static_cast<std::size_t>(y)] + std::int64_t{slice.start} * kGranule;
  }
  static int rounded_up(int count) { return (count + kGranule - 1) & -kGranule; }

 private:
  const Slice* slices() const { return static_cast<const Slice*>(slices_.get()); }

  cv::Size size_;
  AlignedBuffer slices_;           // per pixel: a Slice
  std::vector<std::int64_t> row_;  // first cell of each row, then the number of cells
  int max_count_ = 0;
  Interval hull_;
};

using VolumeShapePtr = std::shared_ptr<const VolumeShape>;

/// One number per pixel and disparity. Cells are not initialised; the first cell is aligned to
/// kBufferAlignment bytes. Volumes can be moved, not copied.
template <class Cell>
class Volume {
 public:
  /// Marks a disparity that cannot be matched (outside the match image, or no data there).
  /// Absorbing: such a cell stays kNoMatch through aggregation and never wins.
  static constexpr Cell kNoMatch = std::numeric_limits<Cell>::max();

  explicit Volume(VolumeShapePtr shape)
      : shape_(std::move(shape)),
        cells_(new_buffer(static_cast<std::size_t>(shape_->cells()) * sizeof(Cell))) {}

  const VolumeShape& shape() const { return *shape_; }
  const VolumeShapePtr& shape_ptr() const { return shape_; }
  /// First cell of a pixel; shape().count(y, x) cells follow.
  Cell* at(int y, int x) { return data() + shape_->offset(y, x); }
  const Cell* at(int y, int x) const { return data() + shape_->offset(y, x); }
  /// All cells of a pixel.
  std::span<const Cell> cells(int y, int x) const {
    return {at(y, x), static_cast<std::size_t>(shape_->count(y, x))};
  }
  Cell* data() { return static_cast<Cell*>(cells_.get()); }
  const Cell* data() const { return static_cast<const Cell*>(cells_.get()); }
  std::size_t bytes() const { return static_cast<std::size_t>(shape_->cells()) * sizeof(Cell); }

 private:
  VolumeShapePtr shape_;
  AlignedBuffer cells_;
};

/// Matching costs C(p, d), 8 bit. Every cell is at most max_cost, or kNoMatch (255).
struct CostVolume : Volume<std::uint8_t> {
  CostVolume(VolumeShapePtr shape, int bound) : Volume(std::move(shape)), max_cost(bound) {}
  int max_cost;  ///< bound of the cost function itself, not of this image: 0 to 254
};

/// Sums S(p, d) over the path directions, 16 bit, in units of 2^-fraction_bits of a cost. The sums
/// of a pixel are correct up to a constant of that pixel: path costs are bounded by subtracting
/// their minimum, which changes no winner.
struct AggregatedVolume : Volume<std::uint16_t> {
  AggregatedVolume(VolumeShapePtr shape, int bits)
      : Volume(std::move(shape)), fraction_bits(bits) {}
  int fraction_bits;
};

}  // namespace xgm
