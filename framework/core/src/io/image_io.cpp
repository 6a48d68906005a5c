// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/image_io.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "io/marks.hpp"
#include "io/raster.hpp"
#include "io/warnings.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/pfm.hpp"

namespace xgm {
namespace {

/// level = (value - offset) * gain
struct Scaling {
  double offset = 0;
  double gain = 1;
  std::string note;
};

struct Extremes {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

void widen(Extremes& extremes, const Raster& raster) {
  for (const cv::Mat1f& plane : raster.planes) {
    if (!raster.valid.empty() && cv::countNonZero(raster.valid) == 0) return;
    double low = 0, high = 0;
    cv::minMaxIdx(plane, &low, &high, nullptr, nullptr, raster.valid);
    extremes.low = std::min(extremes.low, low);
    extremes.high = std::max(extremes.high, high);
  }
}

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

Scaling choose_scaling(const Raster& left, const Raster& right) {
  if (left.depth == CV_8U) return {};
  Extremes values;
  widen(values, left);
  widen(values, right);
  if (values.low > values.high) return {};  // no data at all
  return left.depth == CV_16U ? scaling_16_bit(values.high) : scaling_of_floats(values);
}

void require_same(const Raster& left, const Raster& right) {
  if (left.size() != right.size()) {
    throw Error(right.file + ": is " + size_text(right.size()) + " pixels but " + left.file +
                " is " + size_text(left.size()) + "; give a rectified pair of one size");
  }
  if (left.depth != right.depth) {
    throw Error(right.file + ": is " + depth_name(right.depth) + " but " + left.file + " is " +
                depth_name(left.depth) + "; convert them to one depth");
  }
}

void apply_mask(Raster& raster, const std::string& file, std::vector<std::string>& warnings) {
  if (file.empty()) return;
  const cv::Mat1b mask = take(read_mask(file, MaskUse::usable), warnings);
  if (mask.size() != raster.size()) {
    throw Error(file + ": is " + size_text(mask.size()) + " pixels but " + raster.file + " is " +
                size_text(raster.size()) + "; a mask has the size of its image");
  }
  const cv::Mat1b valid(mask != 0);
  raster.valid = raster.valid.empty() ? valid : cv::Mat1b(raster.valid & valid);
}

/// Uses the raster up: planes are scaled in place, no second copy is held.
Image to_image(Raster raster, const Scaling& scaling) {
  Image image;
  for (cv::Mat1f& plane : raster.planes) {
    if (scaling.gain != 1 || scaling.offset != 0) {
      plane.convertTo(plane, CV_32F, scaling.gain, -scaling.offset * scaling.gain);
    }
    if (!raster.valid.empty()) plane.setTo(0, raster.valid == 0);
  }
  image.planes = std::move(raster.planes);
  image.valid = raster.valid;
  return image;
}

}  // namespace

ReadPair read_pair(const PairFiles& files) {
  Raster left = read_raster(files.left, files.no_data);
  Raster right = read_raster(files.right, files.no_data);
  require_same(left, right);
  ReadPair result;
  apply_mask(left, files.left_mask, result.warnings);
  apply_mask(right, files.right_mask, result.warnings);
  append(result.warnings, mask_marks_of_image(left));
  append(result.warnings, mask_marks_of_image(right));

  const Scaling scaling = choose_scaling(left, right);
  if (!scaling.note.empty()) result.notes.push_back(scaling.note);
  result.pair.base = to_image(std::move(left), scaling);
  result.pair.match = to_image(std::move(right), scaling);
  if (result.pair.base.planes.size() != result.pair.match.planes.size()) {
    result.notes.push_back("one image is grey and the other colour: both are matched as grey");
    for (Image* image : {&result.pair.base, &result.pair.match}) image->planes = {image->grey()};
  }
  return result;
}

namespace {

void write_encoded(const std::string& file, const cv::Mat& image) {
  std::vector<uchar> bytes;
  try {
    cv::imencode(".png", image, bytes);
  } catch (const cv::Exception&) {  // the format's limit; what OpenCV says is about its own source
    throw Error(file + ": " + size_text(image.size()) +
                " pixels cannot be written as PNG, which has up to 1000000 to a side; match a part "
                "of the images");
  }
  write_file(file, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace

void write_png(const std::string& file, const cv::Mat1b& image) { write_encoded(file, image); }
void write_png(const std::string& file, const cv::Mat3b& image) { write_encoded(file, image); }
void write_png(const std::string& file, const cv::Mat1w& image) { write_encoded(file, image); }
void write_png(const std::string& file, const cv::Mat3w& image) { write_encoded(file, image); }

}  // namespace xgm
