// SPDX-License-Identifier: Apache-2.0
#include "io/raster.hpp"

#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm {
namespace {

cv::Mat decode(const std::string& file) {
  try {
    const cv::Mat image = cv::imread(file, cv::IMREAD_UNCHANGED);
    if (!image.empty()) return image;
  } catch (const cv::Exception&) {
    // Says only which check of OpenCV failed; the message below serves for that too.
  }
  throw Error(file + ": is no image that can be read; give a complete PNG, TIFF, JPEG, PNM or PFM");
}

/// Alpha tells where there is data, unless it is zero everywhere: then it was never filled in.
cv::Mat1b mask_of_alpha(const cv::Mat& alpha) {
  if (cv::countNonZero(alpha) == 0) return {};
  const cv::Mat1b valid(alpha != 0);
  return cv::countNonZero(valid) == static_cast<int>(valid.total()) ? cv::Mat1b() : valid;
}

/// Values that are not finite become 0 and masked.
void mask_non_finite(Raster& raster) {
  cv::Mat1b& valid = raster.valid;
  for (cv::Mat1f& plane : raster.planes) {
    for (int y = 0; y < plane.rows; ++y) {
      for (int x = 0; x < plane.cols; ++x) {
        if (std::isfinite(plane(y, x))) continue;
        if (valid.empty()) valid = cv::Mat1b(plane.size(), 255);
        valid(y, x) = 0;
        plane(y, x) = 0;
      }
    }
  }
}

}  // namespace

Raster read_raster(const std::string& file) {
  Raster raster;
  raster.file = file;
  const std::string magic = read_head(file, 3);
  if (magic.starts_with("Pf") || magic.starts_with("PF")) {
    raster.depth = CV_32F;
    raster.planes = read_pfm_planes(file);
  } else {
    const cv::Mat image = decode(file);
    raster.depth = image.depth();
    std::vector<cv::Mat> channels;
    cv::split(image, channels);
    if (channels.size() > 4) {
      throw Error(file + ": has " + std::to_string(channels.size()) +
                  " channels; give a grey (1) or colour (3) image, with or without alpha");
    }
    if (channels.size() % 2 == 0) {
      raster.valid = mask_of_alpha(channels.back());
      channels.pop_back();
    }
    for (cv::Mat& channel : channels) {
      channel.convertTo(raster.planes.emplace_back(), CV_32F);
      channel.release();
    }
  }
  mask_non_finite(raster);
  return raster;
}

std::string depth_name(int depth) {
  switch (depth) {
    case CV_8U:
      return "8-bit";
    case CV_8S:
      return "signed 8-bit";
    case CV_16U:
      return "16-bit";
    case CV_16S:
      return "signed 16-bit";
    case CV_32S:
      return "signed 32-bit";
    case CV_32F:
      return "float";
    default:
      return "double";
  }
}

std::string size_text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}  // namespace xgm
