// SPDX-License-Identifier: Apache-2.0
// Reads image pairs of any common format into grey levels 0 to 255.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/image.hpp"
#include "xgm/data/scene_files.hpp"

namespace xgm {

struct ReadPair {
  ImagePair pair;
  std::vector<std::string> notes;  ///< what was done to the values, for the log
};

/// Reads what OpenCV reads (PNG, JPEG, TIFF, PGM, PPM, BMP, ...) and PFM. Both images are scaled
/// alike:
/// - 8 bit: as it is.
/// - 16 bit: 65535 becomes 255. If no value of either image reaches 4096, it is data of a sensor
///   with 8 to 12 bits in a 16-bit file: 2^bits - 1 becomes 255, with the bits of the largest
///   value.
/// - other (float, double, signed): values within [0, 1] times 255; within [0, 255] as they are;
///   otherwise the smallest and the largest become 0 and 255. NaN and infinite pixels have no data.
/// Pixels without data (masked, or not finite) do not take part in finding the scale; they are 0.
/// An alpha channel masks where it is 0, and is ignored if it is 0 everywhere. A colour and a grey
/// image are both made grey; palettes are resolved. The orientation that a camera noted is ignored.
/// Throws Error, naming the file and the remedy, for a file that is missing, empty, no image or
/// has another number of channels, and for images of different size or depth.
XGM_API ReadPair read_pair(const PairFiles& files);

/// Reads disparities: PFM or another float image (px, not finite = none), or an image of whole
/// numbers (PNG, PGM, ...) whose value / divisor is the disparity in pixels, 0 = none. NaN where
/// there is none. A negative divisor makes the house's signs of reverse maps that are stored as
/// positive numbers. Throws Error, naming the file and the remedy; also for pictures of
/// disparities: colour images whose channels differ, and whole numbers without a divisor that says
/// what they mean.
XGM_API cv::Mat1f read_disparities(const std::string& file, std::optional<double> divisor = {});

/// A map from such a file: pixels with a disparity are valid, the others out of range.
XGM_API DisparityMap read_map(const std::string& file, std::optional<double> divisor = {});

/// Reads a mask of one channel, or the largest of several: 8-bit values as they are (benchmarks
/// tell 128 from 255), other depths as 255 where they are not zero. Throws Error.
XGM_API cv::Mat1b read_mask(const std::string& file);

/// Write a PNG of 8 or 16 bit, grey or blue-green-red. Complete or not at all. Throw Error.
XGM_API void write_png(const std::string& file, const cv::Mat1b& image);
XGM_API void write_png(const std::string& file, const cv::Mat3b& image);
XGM_API void write_png(const std::string& file, const cv::Mat1w& image);
XGM_API void write_png(const std::string& file, const cv::Mat3w& image);

}  // namespace xgm
