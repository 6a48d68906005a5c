// SPDX-License-Identifier: Apache-2.0
#include "xgm/data/pair_windows.hpp"

#include <algorithm>

#include "xgm/data/crop.hpp"
#include "xgm/data/image_parts.hpp"

namespace xgm {

PairWindows::~PairWindows() = default;

ImagePair PairInMemory::read(const cv::Rect& window) const { return crop(pair_, window); }

bool have_same_pixels(const PairWindows& pair) {
  const std::vector<cv::Rect> bands = row_bands(pair.size());
  return std::all_of(bands.begin(), bands.end(), [&](const cv::Rect& band) {
    const ImagePair part = pair.read(band);
    return have_same_pixels(part.base, part.match);
  });
}

}  // namespace xgm
