// SPDX-License-Identifier: Apache-2.0
// The census transform of one image row: a bit string per pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "xgm/data/image.hpp"

namespace xgm::census {

/// Bit strings of the pixels of a row: one bit per neighbour in the window and channel. They are
/// cut into bytes, plane k holding byte k of all pixels: neighbours lie side by side, a vector
/// compares as many pixels as it has bytes, and bits of a byte are counted without widening.
/// Planes reach beyond the row's ends, and one more tells where there is no pixel.
class Descriptors {
 public:
  /// Room for pixels [-before, width + behind).
  Descriptors(int plane_count, int width, int before, int behind)
      : plane_count_(plane_count),
        before_(static_cast<std::size_t>(before)),
        stride_(static_cast<std::size_t>(before + width + behind)),
        bytes_(stride_ * static_cast<std::size_t>(plane_count + 1)) {}

  int plane_count() const { return plane_count_; }
  /// Byte k of pixel 0; the next pixel's is the next byte.
  std::uint8_t* plane(int k) { return bytes_.data() + offset(k); }
  const std::uint8_t* plane(int k) const { return bytes_.data() + offset(k); }
  /// 255 outside the image and where it is masked, else 0.
  std::uint8_t* absent() { return plane(plane_count_); }
  const std::uint8_t* absent() const { return plane(plane_count_); }

 private:
  std::size_t offset(int k) const { return static_cast<std::size_t>(k) * stride_ + before_; }

  int plane_count_;
  std::size_t before_, stride_;
  std::vector<std::uint8_t> bytes_;
};

/// What of an image row is wanted, and how it is laid out.
struct RowLayout {
  bool mirrored = false;  ///< from right to left; bit strings are those of the row as it is
  int before = 0;         ///< pixels that exist in memory before the first one
  int behind = 0;         ///< and behind the last one
};

/// Row y of an image by Zabih & Woodfill 1994: a bit is set where the neighbour is darker than the
/// centre; equal is not darker. A neighbour that does not exist (outside the image, or masked) sets
/// no bit. `window` has odd sides. The descriptor of a masked pixel has no meaning.
Descriptors transform(const Image& image, int y, cv::Size window, const RowLayout& layout = {});

}  // namespace xgm::census
