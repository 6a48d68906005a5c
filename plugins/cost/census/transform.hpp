// SPDX-License-Identifier: Apache-2.0
// The census transform of one image row: a bit string per pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "xgm/data/image.hpp"

namespace xgm::census {

/// Bit strings of the pixels of a row: one bit per neighbour in the window and channel, in words of
/// 64. Word k of pixel x is words[k * width + x], so that neighbours lie side by side.
struct Descriptors {
  int width = 0;
  int channels = 0;
  int word_count = 0;
  std::vector<std::uint64_t> words;

  std::uint64_t* word(int k) { return words.data() + offset(k); }
  const std::uint64_t* word(int k) const { return words.data() + offset(k); }

 private:
  std::size_t offset(int k) const {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(width);
  }
};

/// Zabih & Woodfill 1994: a bit is set where the neighbour is darker than the centre; equal is not
/// darker. A neighbour that does not exist (outside the image, or masked) sets no bit. `window` has
/// odd sides. The descriptor of a masked pixel has no meaning.
Descriptors transform(const Image& image, int y, cv::Size window);

/// The same descriptors from right to left.
Descriptors mirrored(Descriptors row);

}  // namespace xgm::census
