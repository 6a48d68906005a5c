// SPDX-License-Identifier: Apache-2.0
// Maps and pictures as text inside a page.
#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "xgm/base/json.hpp"

namespace xgm::report {

/// Every stride-th pixel of an image, from the middle of its stride: pages show real values of
/// fewer pixels rather than means over edges.
struct Sampling {
  cv::Size full;
  int stride = 1;

  /// The smallest stride that leaves at most `pixels` pixels.
  static Sampling within(cv::Size full, double pixels);
  cv::Size shown() const { return {shorter(full.width), shorter(full.height)}; }
  cv::Point at(int x, int y) const { return {middle(x, full.width), middle(y, full.height)}; }

 private:
  int shorter(int n) const { return (n + stride - 1) / stride; }
  int middle(int i, int n) const { return std::min(i * stride + stride / 2, n - 1); }
};

template <class Pixel>
cv::Mat_<Pixel> sampled(const cv::Mat_<Pixel>& map, const Sampling& sampling) {
  cv::Mat_<Pixel> result(sampling.shown());
  for (int y = 0; y < result.rows; ++y) {
    for (int x = 0; x < result.cols; ++x) result(y, x) = map(sampling.at(x, y));
  }
  return result;
}

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
