// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/point_cloud.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <ostream>
#include <vector>

#include "io/raster.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"

namespace xgm {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void append(std::string& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<char>(bits >> shift & 0xFFu));
  }
}

/// Red, green and blue; planes are blue, green and red, or one of grey.
void append_colour(std::string& bytes, const Image& image, int y, int x) {
  const std::size_t last = image.planes.size() - 1;
  for (std::size_t c = 0; c < 3; ++c) {
    const float level = image.planes[last - std::min(c, last)](y, x);
    bytes.push_back(static_cast<char>(cv::saturate_cast<std::uint8_t>(level)));
  }
}

/// Body of the PLY; its points are counted by the way.
std::string points(const cv::Mat1f& disparity, const Calibration& cameras, const Image& left,
                   std::size_t& count) {
  std::string bytes;
  count = 0;
  for (int y = 0; y < disparity.rows; ++y) {
    for (int x = 0; x < disparity.cols; ++x) {
      const cv::Point3d point = point_of(cameras, x, y, disparity(y, x));
      if (!std::isfinite(point.z)) continue;
      for (const double value : {point.x, point.y, point.z}) {
        append(bytes, static_cast<float>(value));
      }
      append_colour(bytes, left, y, x);
      ++count;
    }
  }
  return bytes;
}

std::string header(std::size_t count) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\n"
      "comment x right, y down, z forward of the left camera, mm\n"
      "element vertex " +
      std::to_string(count) + "\n";
  for (const char* name : {"x", "y", "z"}) text += "property float " + std::string(name) + "\n";
  for (const char* name : {"red", "green", "blue"}) {
    text += "property uchar " + std::string(name) + "\n";
  }
  return text + "end_header\n";
}

}  // namespace

cv::Point3d point_of(const Calibration& cameras, double x, double y, double disparity) {
  const double shift = disparity + cameras.doffs;
  if (!std::isfinite(shift) || shift <= 0) return {kNone, kNone, kNone};
  const double z = cameras.baseline * cameras.focal / shift;
  return {(x - cameras.cx) * z / cameras.focal, (y - cameras.cy) * z / cameras.focal, z};
}

cv::Mat1f depths(const cv::Mat1f& disparity, const Calibration& cameras) {
  cv::Mat1f result(disparity.size());
  for (int y = 0; y < result.rows; ++y) {
    for (int x = 0; x < result.cols; ++x) {
      result(y, x) = static_cast<float>(point_of(cameras, x, y, disparity(y, x)).z);
    }
  }
  return result;
}

void write_depths(const std::string& file, const cv::Mat1f& depths) {
  std::vector<uchar> bytes;
  if (!cv::imencode(".tiff", depths, bytes)) throw Error(file + ": cannot be encoded as TIFF");
  write_file(file, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::size_t write_point_cloud(const std::string& file, const cv::Mat1f& disparity,
                              const Calibration& cameras, const Image& left) {
  if (left.size() != disparity.size()) {
    throw Error(file + ": the image is " + size_text(left.size()) + " pixels but the map is " +
                size_text(disparity.size()) + "; colours are taken pixel for pixel");
  }
  std::size_t count = 0;
  const std::string body = points(disparity, cameras, left, count);
  write_file(file, [&](std::ostream& stream) { stream << header(count) << body; });
  return count;
}

}  // namespace xgm
