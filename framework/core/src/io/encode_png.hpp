// SPDX-License-Identifier: Apache-2.0
// The bytes of a PNG, for those who do not write it at once.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace xgm {

/// `file` is what the Error names if the image is too large for a PNG.
std::string encode_png(const std::string& file, const cv::Mat& image);

}  // namespace xgm
