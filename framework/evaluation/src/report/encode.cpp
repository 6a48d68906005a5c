// SPDX-License-Identifier: Apache-2.0
#include "report/encode.hpp"

#include <algorithm>
#include <limits>
#include <opencv2/imgcodecs.hpp>

namespace xgm::report {
namespace {

constexpr int kLargestCode = 65535;
constexpr double kFinestStep = 1.0 / 1024;  // px; matchers are right to a tenth or so
constexpr int kJpegQuality = 88;

std::vector<uchar> encoded(const cv::Mat& image) {
  std::vector<uchar> bytes;
  constexpr int kLevel = 7;  // above it, time grows and size hardly falls
  cv::imencode(".png", image, bytes,
               {cv::IMWRITE_PNG_COMPRESSION, kLevel, cv::IMWRITE_PNG_STRATEGY,
                cv::IMWRITE_PNG_STRATEGY_FILTERED});
  return bytes;
}

struct Bounds {
  double low = 0;
  double high = 0;
};

Bounds bounds_of(const cv::Mat1f& values) {
  Bounds bounds{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    bounds.low = std::min(bounds.low, static_cast<double>(value));
    bounds.high = std::max(bounds.high, static_cast<double>(value));
  }
  return bounds.low <= bounds.high ? bounds : Bounds{};
}

}  // namespace

std::string base64(const std::vector<uchar>& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[three >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

std::vector<uchar> png(const cv::Mat1b& image) { return encoded(image); }
std::vector<uchar> png(const cv::Mat3b& image) { return encoded(image); }

std::string png_uri(const cv::Mat3b& image) {
  return "data:image/png;base64," + base64(png(image));
}

std::string jpeg_uri(const cv::Mat3b& image) {
  std::vector<uchar> bytes;
  cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  return "data:image/jpeg;base64," + base64(bytes);
}

Json packed_numbers(const cv::Mat1f& values) {
  const Bounds bounds = bounds_of(values);
  double step = kFinestStep;
  while ((bounds.high - bounds.low) / step > kLargestCode - 2) step *= 2;
  const double first = std::round(bounds.low / step) - 1;  // so that the lowest value has code 1
  cv::Mat1w codes(values.size(), std::uint16_t{0});
  for (int y = 0; y < values.rows; ++y) {
    for (int x = 0; x < values.cols; ++x) {
      if (!std::isfinite(values(y, x))) continue;
      const double code = std::round(static_cast<double>(values(y, x)) / step) - first;
      codes(y, x) = cv::saturate_cast<std::uint16_t>(std::clamp<double>(code, 1, kLargestCode));
    }
  }
  return {{"png", base64(encoded(codes))}, {"first", first}, {"step", step}};
}

Json packed_codes(const cv::Mat1b& codes) { return {{"png", base64(png(codes))}}; }

}  // namespace xgm::report
