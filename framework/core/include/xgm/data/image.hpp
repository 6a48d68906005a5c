// SPDX-License-Identifier: Apache-2.0
// The rectified image pair that is matched.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// One view. `planes` holds one plane (grey) or three (blue, green, red), all of one size, in grey
/// levels: 0 to 255 for 8-bit images; 16-bit and float images are scaled to that range when they
/// are read, so that thresholds mean the same everywhere. `valid` is empty (all pixels count) or
/// non-zero where a pixel may be used: no-data pixels never match and never vote.
struct XGM_API Image {
  std::vector<cv::Mat1f> planes;
  cv::Mat1b valid;

  Image() = default;
  explicit Image(cv::Mat1f grey) : planes{std::move(grey)} {}

  cv::Size size() const { return planes.empty() ? cv::Size() : planes.front().size(); }
  bool is_valid(int y, int x) const { return valid.empty() || valid(y, x) != 0; }

  /// One plane: the luma 0.299 R + 0.587 G + 0.114 B of a colour image, the plane itself of a grey
  /// one.
  cv::Mat1f grey() const;
};

/// Base (left, reference) and match (right) view. A pixel (x, y) of the base with disparity d is
/// seen at (x - d, y) of the match image. Both have the same size.
struct XGM_API ImagePair {
  Image base;
  Image match;
  /// Whether the base is the right view: what is near has the lower disparities then.
  bool is_reverse = false;

  cv::Size size() const { return base.size(); }
  /// The same pair seen from the other view; its disparities are the negatives.
  ImagePair swapped() const { return {match, base, !is_reverse}; }
};

/// Throws UsageError unless both images have pixels, one or three planes, and all planes and masks
/// of both are of one size.
XGM_API void require_sound(const ImagePair& pair);

}  // namespace xgm
