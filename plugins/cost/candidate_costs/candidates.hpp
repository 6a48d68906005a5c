// SPDX-License-Identifier: Apache-2.0
// What the costs that compare pixel with pixel share: rows of the two views, laid out so that the
// candidates of a base pixel lie side by side and exist in memory for every cell of a slice.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "xgm/base/parallel.hpp"
#include "xgm/data/image.hpp"
#include "xgm/data/volume.hpp"

namespace xgm::cost {

/// How an image row is laid out.
struct RowLayout {
  bool mirrored = false;  ///< from right to left
  int before = 0;         ///< pixels that exist in memory before the first one
  int behind = 0;         ///< and behind the last one
};

/// What is compared of the pixels of an image row: some numbers each, in planes, so that neighbours
/// lie side by side. One more plane tells where there is no pixel.
template <class Number>
class PixelRow {
 public:
  /// Planes of zeros for row y of the image.
  PixelRow(const Image& image, int y, int plane_count, const RowLayout& layout)
      : plane_count_(plane_count),
        before_(static_cast<std::size_t>(layout.before)),
        stride_(static_cast<std::size_t>(layout.before + image.size().width + layout.behind)),
        numbers_(stride_ * static_cast<std::size_t>(plane_count)),
        absent_(stride_, std::uint8_t{255}) {
    const int width = image.size().width;
    std::uint8_t* const absent = absent_.data() + before_;
    std::fill_n(absent, width, std::uint8_t{0});
    if (image.valid.empty()) return;
    const std::uint8_t* const valid = image.valid[y];
    for (int x = 0; x < width; ++x) absent[x] = valid[x] != 0 ? 0 : 255;
    if (layout.mirrored) std::reverse(absent, absent + width);
  }

  int plane_count() const { return plane_count_; }
  /// Number k of pixel 0; the next pixel's is the next element.
  Number* plane(int k) { return numbers_.data() + offset(k); }
  const Number* plane(int k) const { return numbers_.data() + offset(k); }
  /// From a plane to the next one.
  std::size_t stride() const { return stride_; }
  /// 255 outside the image and where it is masked, else 0; from pixel 0 on.
  const std::uint8_t* absent() const { return absent_.data() + before_; }

 private:
  std::size_t offset(int k) const { return static_cast<std::size_t>(k) * stride_ + before_; }

  int plane_count_;
  std::size_t before_, stride_;
  std::vector<Number> numbers_;
  std::vector<std::uint8_t> absent_;
};

/// A row of each view. The match row is mirrored, for ascending disparity walks it backwards.
template <class Number>
struct RowPair {
  const PixelRow<Number>& base;
  const PixelRow<Number>& match;
  int channels = 1;

  /// Where in the match row the first candidate of a base pixel is; the others follow.
  static int first(const VolumeShape& shape, int y, int x) {
    return shape.width() - 1 - x + shape.begin(y, x);
  }
};

template <class Number>
RowPair(const PixelRow<Number>&, const PixelRow<Number>&, int) -> RowPair<Number>;

/// The layout of match rows that hold a candidate, or say that there is none, for every cell of the
/// volume and for what lies between a slice's last cell and its end.
inline RowLayout candidates_of(const VolumeShape& shape) {
  const Interval hull = shape.hull();
  return {true, std::max(0, -hull.begin), std::max(0, hull.end) + VolumeShape::kGranule};
}

/// The pair with as many planes in one view as in the other: as it is, or both as grey images.
inline ImagePair comparable(const ImagePair& pair) {
  ImagePair result = pair;
  if (pair.base.planes.size() != pair.match.planes.size()) {
    result.base.planes = {pair.base.grey()};
    result.match.planes = {pair.match.grey()};
  }
  return result;
}

/// Fills a volume row by row: make(image, y, layout) makes a PixelRow, compare(RowPair, y, costs)
/// writes all cells that the slices of row y have room for.
template <class Make, class Compare>
CostVolume compare_rows(const ImagePair& images, const VolumeShapePtr& shape, int max_cost,
                        Make make, Compare compare) {
  const ImagePair pair = comparable(images);
  const auto channels = static_cast<int>(pair.base.planes.size());
  const RowLayout mirrored = candidates_of(*shape);
  CostVolume costs(shape, max_cost);
  parallel_for(0, shape->height(), [&](int y) {
    const auto base = make(pair.base, y, RowLayout{});
    const auto match = make(pair.match, y, mirrored);
    compare(RowPair{base, match, channels}, y, costs);
  });
  return costs;
}

}  // namespace xgm::cost
