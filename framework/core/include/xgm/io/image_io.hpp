// SPDX-License-Identifier: Apache-2.0
// Reads image pairs of all common formats as grey levels 0 to 255; reads disparities and masks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"
#include "xgm/data/image.hpp"
#include "xgm/data/scene_files.hpp"

namespace xgm {

/// What a file holds, and what is doubtful in it: one sentence each, which names the file.
template <class What>
struct Noted {
  What value;
  std::vector<std::string> warnings;
};

/// An image as it is stored in a file or in a program's memory: its values are no grey levels yet.
struct UnscaledImage {
  std::string file{};             ///< or what else messages call it
  int depth = CV_8U;              ///< OpenCV's code of the stored type
  std::vector<cv::Mat1f> planes;  ///< one (grey) or three (blue, green, red), values as stored
  cv::Mat1b valid{};              ///< empty, or 0 where there is no data
  bool is_shared = false;         ///< whether the planes are also somebody else's: never written to

  cv::Size size() const { return planes.front().size(); }
  bool is_valid(int y, int x) const { return valid.empty() || valid(y, x) != 0; }
  bool holds_whole_numbers() const { return depth != CV_32F && depth != CV_64F; }
};

struct ReadPair {
  ImagePair pair;
  std::vector<std::string> notes;     ///< how values were converted, for the log
  std::vector<std::string> warnings;  ///< what is doubtful in the files
};

/// Reads PNG, JPEG, TIFF, PNM, BMP, WebP, JPEG 2000, Sun raster, Radiance, EXR and PFM. Both
/// images are scaled in the same way:
/// - 8 bit: unchanged.
/// - 16 bit: 65535 becomes 255. If all values of both images are below 4096, they are data of a
///   sensor of 8 to 12 bits in a 16-bit file: 2^bits - 1 becomes 255, where the largest value
///   determines the number of bits.
/// - other (float, double, signed): values within [0, 1] are multiplied by 255; values from 0 to
///   255 are unchanged; otherwise the smallest becomes 0 and the largest 255. NaN and infinite
///   pixels have no data.
/// Pixels without data (masked, not finite, or with a value that means no data:
/// docs/conventions.md) do not influence the scale; their value is 0. Alpha 0 masks a pixel, unless
/// alpha is 0 everywhere. If only one image is in colour, both become grey; palettes are resolved.
/// The orientation recorded by a camera is ignored. Throws Error, naming the file and the remedy,
/// if a file is missing, empty, cut short, longer than its header says, not an image or has an
/// unsupported number of channels, and if the images differ in size or depth.
XGM_API ReadPair read_pair(const PairFiles& files);

/// An image in memory of any depth and of one to four channels, the second or fourth of which is
/// alpha. A float image of one channel is shared, not copied. A pixel has no data where alpha is 0,
/// unless it is so everywhere, or where a value is not finite. Throws Error.
XGM_API UnscaledImage to_unscaled(std::string name, cv::InputArray image);

/// Masks the pixels where `usable`, of the image's size, is 0.
XGM_API void apply_mask(UnscaledImage& image, const cv::Mat1b& usable);

/// What read_pair() makes of two files, of images in memory. Shared planes that need no change are
/// used as they are. Throws Error if the images differ in size or depth.
XGM_API ReadPair to_pair(UnscaledImage left, UnscaledImage right);

/// Reads disparities: PFM or another float image (px, not finite = none), or an image of whole
/// numbers (PNG, PGM, ...) whose value / divisor is the disparity in pixels, 0 = none. Values as
/// stored that equal one of `no_data`, or the file's tag GDAL_NODATA, mean none, too. The result
/// is NaN where there is no disparity. A reverse map that is stored as positive numbers needs a
/// negative divisor. Throws Error, naming the file and the remedy; also for pictures of
/// disparities, that is for colour images whose channels differ, and for whole numbers without a
/// divisor.
XGM_API Noted<cv::Mat1f> read_disparities(const std::string& file,
                                          std::optional<double> divisor = {},
                                          const std::vector<double>& no_data = {});

/// A map from such a file: pixels with a disparity are `matched`, the others `out_of_range`.
XGM_API Noted<DisparityMap> read_map(const std::string& file, std::optional<double> divisor = {},
                                     const std::vector<double>& no_data = {});

/// What the values of a mask say.
enum class MaskUse {
  usable,  ///< of an image: not 0 where a pixel may be used
  judged,  ///< of a truth: 255 where maps are judged, 128 where they are not, 0 where it is unknown
  objects  ///< of a truth: not 0 on objects, often with a number for each
};

/// Reads a mask; of several channels, takes the maximum. 8-bit values are unchanged; nonzero values
/// of other depths become 255, and so does 1 in a mask of zeros and ones. 0 where the file has no
/// data (alpha 0, NaN, GDAL_NODATA). Warns of values that the use does not know, and says how they
/// are understood. Throws Error.
XGM_API Noted<cv::Mat1b> read_mask(const std::string& file, MaskUse use);

/// Write an 8- or 16-bit PNG, grey or blue-green-red. The file is complete or absent. Throw Error.
XGM_API void write_png(const std::string& file, const cv::Mat1b& image);
XGM_API void write_png(const std::string& file, const cv::Mat3b& image);
XGM_API void write_png(const std::string& file, const cv::Mat1w& image);
XGM_API void write_png(const std::string& file, const cv::Mat3w& image);

}  // namespace xgm
