// SPDX-License-Identifier: Apache-2.0
// An image file as it is stored, before its values are scaled.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace xgm {

struct Raster {
  std::string file;
  int depth = CV_8U;              ///< OpenCV's code of the stored type
  std::vector<cv::Mat1f> planes;  ///< one (grey) or three (blue, green, red), values as stored
  cv::Mat1b valid;                ///< empty, or 0 where alpha is 0 or a value is not finite

  cv::Size size() const { return planes.front().size(); }
};

/// Decodes any format. Throws Error.
Raster read_raster(const std::string& file);

/// "8-bit", "16-bit", "float", ...
std::string depth_name(int depth);

/// "640 x 480"
std::string size_text(cv::Size size);

}  // namespace xgm
