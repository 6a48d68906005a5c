// SPDX-License-Identifier: Apache-2.0
#include "io/grey_levels.hpp"

#include <algorithm>
#include <bit>
#include <sstream>

#include "xgm/base/error.hpp"

namespace xgm {
namespace {

Scaling scaling_16_bit(double highest) {
  if (highest >= 4096) return {0, 255.0 / 65535.0, "16-bit images: 65535 is taken for white"};
  const int bits = std::max(8, static_cast<int>(std::bit_width(static_cast<unsigned>(highest))));
  const int white = (1 << bits) - 1;
  return {0, 255.0 / white,
          "16-bit images hold " + std::to_string(bits) + "-bit data: " + std::to_string(white) +
              " is taken for white"};
}

Scaling scaling_of_floats(const Extremes& values) {
  if (values.low >= 0 && values.high <= 1) return {0, 255, "values of 0 to 1: 1 is white"};
  if (values.low >= 0 && values.high <= 255) return {0, 1, ""};
  const double span = values.high - values.low;
  std::ostringstream note;
  note << "values of " << values.low << " to " << values.high
       << " are mapped to grey levels 0 to 255";
  return {values.low, span > 0 ? 255 / span : 0, note.str()};
}

}  // namespace

void Extremes::add(const UnscaledImage& raster) {
  if (!raster.valid.empty() && cv::countNonZero(raster.valid) == 0) return;
  for (const cv::Mat1f& plane : raster.planes) {
    double plane_low = 0, plane_high = 0;
    cv::minMaxIdx(plane, &plane_low, &plane_high, nullptr, nullptr, raster.valid);
    low = std::min(low, plane_low);
    high = std::max(high, plane_high);
  }
}

Scaling choose_scaling(int depth, const Extremes& values) {
  if (depth == CV_8U || values.low > values.high) return {};  // or no data at all
  return depth == CV_16U ? scaling_16_bit(values.high) : scaling_of_floats(values);
}

void require_same(const Stored& left, const Stored& right) {
  if (left.size != right.size) {
    throw Error(right.file + ": is " + size_text(right.size) + " pixels but " + left.file + " is " +
                size_text(left.size) + "; give a rectified pair of one size");
  }
  if (left.depth != right.depth) {
    throw Error(right.file + ": is " + depth_name(right.depth) + " but " + left.file + " is " +
                depth_name(left.depth) + "; convert them to one depth");
  }
}

void require_mask_of(const Stored& image, const std::string& mask, cv::Size size) {
  if (size == image.size) return;
  throw Error(mask + ": is " + size_text(size) + " pixels but " + image.file + " is " +
              size_text(image.size) + "; a mask has the size of its image");
}

Image to_image(UnscaledImage raster, const Scaling& scaling) {
  Image image;
  const bool is_scaled = scaling.gain != 1 || scaling.offset != 0;
  for (cv::Mat1f& plane : raster.planes) {
    if (raster.is_shared && (is_scaled || !raster.valid.empty())) plane = plane.clone();
    if (is_scaled) plane.convertTo(plane, CV_32F, scaling.gain, -scaling.offset * scaling.gain);
    if (!raster.valid.empty()) plane.setTo(0, raster.valid == 0);
  }
  image.planes = std::move(raster.planes);
  image.valid = raster.valid;
  return image;
}

}  // namespace xgm
