// SPDX-License-Identifier: Apache-2.0
// The rectified image pair to match.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// One view. `planes` holds one plane (grey) or three (blue, green, red), all of one size, in grey
/// levels: 0 to 255 for 8-bit images; 16-bit and float images are scaled to that range when they
/// are read, so that thresholds have the same meaning for all images. `valid` is empty (all pixels
/// have data), or nonzero where a pixel has data. Pixels without data are never matched, and never
/// influence other pixels.
struct XGM_API Image {
  std::vector<cv::Mat1f> planes;
  cv::Mat1b valid;

  Image() = default;
  explicit Image(cv::Mat1f grey) : planes{std::move(grey)} {}

  cv::Size size() const { return planes.empty() ? cv::Size() : planes.front().size(); }
  bool is_valid(int y, int x) const { return valid.empty() || valid(y, x) != 0; }

  /// One plane: the luma 0.299 R + 0.587 G + 0.114 B of a colour image, or the plane of a grey
  /// image.
  cv::Mat1f grey() const;
};

/// Base (left, reference) and match (right) view, of the same size. Pixel (x, y) of the base image
/// with disparity d corresponds to (x - d, y) of the match image.
struct XGM_API ImagePair {
  Image base;
  Image match;
  /// Whether the base is the right view. Near objects then have the lower disparities.
  bool is_reverse = false;

  cv::Size size() const { return base.size(); }
  /// The pair with base and match exchanged. Its disparities have the opposite sign.
  ImagePair swapped() const { return {match, base, !is_reverse}; }
};

/// Whether two images of one size have the same values in all planes, bit for bit.
XGM_API bool have_same_pixels(const Image& a, const Image& b);

/// Throws UsageError unless both images have pixels, one or three planes, and all planes and masks
/// of both are of one size.
XGM_API void require_sound(const ImagePair& pair);

}  // namespace xgm
