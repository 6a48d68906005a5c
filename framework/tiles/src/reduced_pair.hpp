// SPDX-License-Identifier: Apache-2.0
// A smaller pair, of images that are not held.
#pragma once

#include "xgm/data/pair_windows.hpp"

namespace xgm::tiles {

/// A length `scale` times smaller, rounded up.
constexpr int reduced(int length, int scale) { return (length + scale - 1) / scale; }

/// A window whose corner is a multiple of the scale.
inline cv::Rect reduced(const cv::Rect& window, int scale) {
  return {window.x / scale, window.y / scale, reduced(window.width, scale),
          reduced(window.height, scale)};
}

/// Both images `scale` times smaller, a power of two.
ImagePair reduced_pair(const PairWindows& pair, int scale);

}  // namespace xgm::tiles
