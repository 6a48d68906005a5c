// SPDX-License-Identifier: Apache-2.0
#include "io/unscaled_image.hpp"

#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "io/image_formats.hpp"
#include "io/possible_size.hpp"
#include "io/tiff.hpp"
#include "io/whole_file.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm {
namespace {

void require_bands(const std::string& name, const cv::Mat& image) {
  if (image.channels() <= 4) return;
  throw Error(name + ": has " + std::to_string(image.channels()) +
              " channels; give a grey (1) or colour (3) image, with or without alpha");
}

StoredImage decode(const std::string& file) {
  cv::Mat image;
  try {
    image = cv::imread(file, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    // Says only which check of OpenCV failed; the message below serves for that too.
  }
  if (image.empty()) throw no_image(file);
  require_bands(file, image);
  return split_bands(image);
}

/// Alpha that is 0 everywhere was never filled in.
bool is_alpha_used(const StoredImage& stored) {
  return !stored.alpha.empty() && cv::countNonZero(stored.alpha) > 0;
}

/// Empty if all pixels have data.
cv::Mat1b mask_of_alpha(const cv::Mat& alpha) {
  const cv::Mat1b valid(alpha != 0);
  return cv::countNonZero(valid) == static_cast<int>(valid.total()) ? cv::Mat1b() : valid;
}

/// Takes pixels out of the valid ones where all bands equal the value.
void mask_value(cv::Mat1b& valid, const std::vector<cv::Mat>& channels, double value) {
  if (std::isnan(value)) return;  // masked as not finite
  cv::Mat1b equal;
  for (const cv::Mat& channel : channels) {
    const cv::Mat1b equal_here(channel == value);
    equal = equal.empty() ? equal_here : cv::Mat1b(equal & equal_here);
  }
  if (cv::countNonZero(equal) == 0) return;
  if (valid.empty()) valid = cv::Mat1b(equal.size(), 255);
  valid.setTo(0, equal);
}

/// Values that are not finite become masked, and 0 where nobody shares them.
void mask_non_finite(UnscaledImage& raster) {
  if (raster.holds_whole_numbers()) return;
  cv::Mat1b& valid = raster.valid;
  for (cv::Mat1f& plane : raster.planes) {
    for (int y = 0; y < plane.rows; ++y) {
      for (int x = 0; x < plane.cols; ++x) {
        if (std::isfinite(plane(y, x))) continue;
        if (valid.empty()) valid = cv::Mat1b(plane.size(), 255);
        valid(y, x) = 0;
        if (!raster.is_shared) plane(y, x) = 0;
      }
    }
  }
}

}  // namespace

StoredImage split_bands(const cv::Mat& pixels) {
  StoredImage stored;
  cv::split(pixels, stored.channels);
  if (stored.channels.size() % 2 == 0) {
    stored.alpha = stored.channels.back();
    stored.channels.pop_back();
  }
  return stored;
}

StoredImage read_stored(const std::string& file) {
  const std::string head = read_head(file, kImageHead);
  if (head.starts_with("Pf") || head.starts_with("PF")) {
    const std::vector<cv::Mat1f> planes = read_pfm_planes(file);
    return {.channels = {planes.begin(), planes.end()}};
  }
  if (!is_tiff(head)) {
    require_possible_header(file, head);
    require_whole(file, head);
    return decode(file);
  }
  StoredImage image = read_tiff(file);
  if (!image.channels.empty()) return image;
  StoredImage decoded = decode(file);
  decoded.no_data = image.no_data;
  return decoded;
}

UnscaledImage to_unscaled(StoredImage stored, const std::string& file, bool alpha,
                          const std::vector<double>& no_data) {
  UnscaledImage raster{.file = file, .planes = {}};
  raster.depth = stored.channels.front().depth();
  if (alpha && !stored.alpha.empty()) raster.valid = mask_of_alpha(stored.alpha);
  if (stored.no_data) mask_value(raster.valid, stored.channels, *stored.no_data);
  for (const double value : no_data) mask_value(raster.valid, stored.channels, value);
  for (cv::Mat& channel : stored.channels) {
    channel.convertTo(raster.planes.emplace_back(), CV_32F);
    channel.release();
  }
  mask_non_finite(raster);
  return raster;
}

UnscaledImage read_unscaled(const std::string& file, const std::vector<double>& no_data) {
  StoredImage stored = read_stored(file);
  const bool alpha = is_alpha_used(stored);
  return to_unscaled(std::move(stored), file, alpha, no_data);
}

UnscaledImage to_unscaled(std::string name, cv::InputArray image) {
  const cv::Mat pixels = image.getMat();
  if (pixels.type() != CV_32FC1) {
    require_bands(name, pixels);
    StoredImage stored = split_bands(pixels);
    const bool alpha = is_alpha_used(stored);
    return to_unscaled(std::move(stored), name, alpha, {});
  }
  UnscaledImage shared{
      .file = std::move(name), .depth = CV_32F, .planes = {pixels}, .is_shared = true};
  mask_non_finite(shared);
  return shared;
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
