// SPDX-License-Identifier: Apache-2.0
// Writes PNGs of the kinds that OpenCV does not write.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace xgm::testing {

struct PngStyle {
  int colour_type = 0;  ///< PNG's: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGB and alpha
  bool interlaced = false;
  bool transparent_colour = false;  ///< one colour is transparent (tRNS)
};

/// Bands lie together, in the order of the file, 8 or 16 bits each.
void write_png_as(const std::string& file, const cv::Mat& pixels, const PngStyle& style);

}  // namespace xgm::testing
