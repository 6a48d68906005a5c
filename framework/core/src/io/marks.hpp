// SPDX-License-Identifier: Apache-2.0
// Marks: values such as -9999 by which a file means "no data" without saying so. The rules are in
// docs/conventions.md.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "io/unscaled_image.hpp"

namespace xgm {

/// Values that mean no data in a file.
struct Marks {
  double never = std::numeric_limits<double>::infinity();  ///< no value is larger than this
  std::vector<double> values{};

  bool empty() const { return values.empty() && never > std::numeric_limits<float>::max(); }
};

/// Takes pixels that hold them out of `raster.valid`.
void mask(UnscaledImage& raster, const Marks& marks);

/// Values that no disparity can be are taken out of `map.valid`; values that may be marks are kept.
/// `divisor` makes px of the values. Returns a warning of each.
std::vector<std::string> mask_marks_of_map(UnscaledImage& map, double divisor);

/// The same for an image. One of 8 bit has none.
std::vector<std::string> mask_marks_of_image(UnscaledImage& image);

using TakeImage = std::function<void(UnscaledImage& part)>;

/// A file that is looked at several times, part by part, from the top.
struct MarkedFile {
  std::string name;
  cv::Size size;
  std::function<void(const TakeImage&)> each_part;  ///< gives each part, the same every time
};

struct FoundMarks {
  Marks marks{};
  std::vector<std::string> warnings{};
};

/// What mask_marks_of_image() does to a file that is not held; the caller masks what it reads.
FoundMarks marks_of_image(const MarkedFile& file, int depth);

}  // namespace xgm
