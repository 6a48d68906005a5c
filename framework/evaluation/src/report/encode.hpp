// SPDX-License-Identifier: Apache-2.0
// Maps and pictures as text inside a page.
#pragma once

#include <cmath>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "xgm/base/json.hpp"
#include "xgm/io/sampling.hpp"

namespace xgm::report {

std::string base64(const std::vector<uchar>& bytes);

std::vector<uchar> png(const cv::Mat1b& image);
std::vector<uchar> png(const cv::Mat3b& image);
std::string png_uri(const cv::Mat3b& image);
std::string jpeg_uri(const cv::Mat3b& image);

/// Numbers as 16-bit fixed point: {png, first, step}, value = (first + code) * step with codes of 1
/// and above, 0 where the value is not finite. The step is the power of two, 1/1024 at least, that
/// the span of the values asks for, so that whole and half pixels stay what they are.
Json packed_numbers(const cv::Mat1f& values);

/// 8-bit codes as they are: {png}.
Json packed_codes(const cv::Mat1b& codes);

}  // namespace xgm::report
