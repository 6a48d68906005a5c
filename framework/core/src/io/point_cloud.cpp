// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/point_cloud.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "io/unscaled_image.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/ply.hpp"

namespace xgm {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Red, green and blue; planes are blue, green and red, or one of grey.
std::array<double, 3> colour(const Image& image, int y, int x) {
  const std::size_t last = image.planes.size() - 1;
  std::array<double, 3> levels{};
  for (std::size_t c = 0; c < 3; ++c) levels[c] = image.planes[last - std::min(c, last)](y, x);
  return levels;
}

/// Calls body(point, y, x) for every pixel that has one.
template <class Body>
void for_each_point(const cv::Mat1f& disparity, const Calibration& cameras, const Body& body) {
  for (int y = 0; y < disparity.rows; ++y) {
    for (int x = 0; x < disparity.cols; ++x) {
      const cv::Point3d point = point_of(cameras, x, y, disparity(y, x));
      if (std::isfinite(point.z)) body(point, y, x);
    }
  }
}

PlyHeader header() {
  PlyHeader header;
  header.comments = {"x right, y down, z forward of the left camera, mm"};
  for (const char* name : {"x", "y", "z"}) header.properties.push_back({name, PlyType::float32});
  for (const char* name : {"red", "green", "blue"}) {
    header.properties.push_back({name, PlyType::uint8});
  }
  return header;
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
  PlyHeader table = header();
  for_each_point(disparity, cameras, [&](const cv::Point3d&, int, int) { ++table.count; });
  write_ply(file, table, [&](const PutVertex& put) {
    for_each_point(disparity, cameras, [&](const cv::Point3d& point, int y, int x) {
      const auto [red, green, blue] = colour(left, y, x);
      put(std::array{point.x, point.y, point.z, red, green, blue});
    });
  });
  return table.count;
}

}  // namespace xgm
