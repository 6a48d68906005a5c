// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/image_io.hpp"

#include <opencv2/imgcodecs.hpp>

#include "io/encode_png.hpp"
#include "io/grey_levels.hpp"
#include "io/marks.hpp"
#include "io/unscaled_image.hpp"
#include "io/warnings.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/io/file.hpp"

namespace xgm {
namespace {

Stored stored(const UnscaledImage& raster) { return {raster.file, raster.size(), raster.depth}; }

void apply_mask(UnscaledImage& raster, const std::string& file,
                std::vector<std::string>& warnings) {
  if (file.empty()) return;
  const cv::Mat1b mask = take(read_mask(file, MaskUse::usable), warnings);
  require_mask_of(stored(raster), file, mask.size());
  apply_mask(raster, mask);
}

}  // namespace

void apply_mask(UnscaledImage& image, const cv::Mat1b& usable) {
  const cv::Mat1b valid(usable != 0);
  image.valid = image.valid.empty() ? valid : cv::Mat1b(image.valid & valid);
}

ReadPair read_pair(const PairFiles& files) {
  UnscaledImage left, right;
  parallel_for(0, 2, [&](int i) {
    if (i == 0) left = read_unscaled(files.left, files.no_data);
    if (i == 1) right = read_unscaled(files.right, files.no_data);
  });
  require_same(stored(left), stored(right));
  std::vector<std::string> warnings;
  apply_mask(left, files.left_mask, warnings);
  apply_mask(right, files.right_mask, warnings);
  ReadPair result = to_pair(std::move(left), std::move(right));
  result.warnings.insert(result.warnings.begin(), warnings.begin(), warnings.end());
  return result;
}

ReadPair to_pair(UnscaledImage left, UnscaledImage right) {
  require_same(stored(left), stored(right));
  ReadPair result;
  append(result.warnings, mask_marks_of_image(left));
  append(result.warnings, mask_marks_of_image(right));

  Extremes values;
  if (left.depth != CV_8U) {
    values.add(left);
    values.add(right);
  }
  const Scaling scaling = choose_scaling(left.depth, values);
  if (!scaling.note.empty()) result.notes.push_back(scaling.note);
  result.pair.base = to_image(std::move(left), scaling);
  result.pair.match = to_image(std::move(right), scaling);
  if (result.pair.base.planes.size() != result.pair.match.planes.size()) {
    result.notes.push_back(kMatchedAsGrey);
    for (Image* image : {&result.pair.base, &result.pair.match}) image->planes = {image->grey()};
  }
  return result;
}

std::string encode_png(const std::string& file, const cv::Mat& image) {
  std::vector<uchar> bytes;
  try {
    cv::imencode(".png", image, bytes);
  } catch (const cv::Exception&) {  // the format's limit; what OpenCV says is about its own source
    throw Error(file + ": " + size_text(image.size()) +
                " pixels cannot be written as PNG, which has up to 1000000 to a side; match a part "
                "of the images");
  }
  return {bytes.begin(), bytes.end()};
}

namespace {

void write_encoded(const std::string& file, const cv::Mat& image) {
  write_file(file, encode_png(file, image));
}

}  // namespace

void write_png(const std::string& file, const cv::Mat1b& image) { write_encoded(file, image); }
void write_png(const std::string& file, const cv::Mat3b& image) { write_encoded(file, image); }
void write_png(const std::string& file, const cv::Mat1w& image) { write_encoded(file, image); }
void write_png(const std::string& file, const cv::Mat3w& image) { write_encoded(file, image); }

}  // namespace xgm
