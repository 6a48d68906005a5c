// SPDX-License-Identifier: Apache-2.0
#include "io/marks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include "xgm/base/text.hpp"

namespace xgm {
namespace {

/// One end of the values: its value, in how many pixels it is, and which other value is next to it.
struct End {
  double value = 0;
  std::int64_t pixels = 0;
  double next = 0;  ///< equals `value` if there is no other

  /// `sign` is 1 for the lowest end, -1 for the highest.
  void take(double found, int sign) {
    if (pixels == 0) value = next = found;
    if (found == value) {
      ++pixels;
    } else if (sign * found < sign * value) {
      next = value;
      value = found;
      pixels = 1;
    } else if (next == value || sign * found < sign * next) {
      next = found;
    }
  }
  bool is_of_several_pixels() const { return pixels > 1 && next != value; }
};

struct Ends {
  End low, high;
};

bool bands_equal(const Raster& raster, int y, int x) {
  const float first = raster.planes.front()(y, x);
  return std::all_of(raster.planes.begin(), raster.planes.end(),
                     [&](const cv::Mat1f& plane) { return plane(y, x) == first; });
}

template <class Body>
void for_each_valid(const Raster& raster, Body body) {
  for (int y = 0; y < raster.size().height; ++y) {
    for (int x = 0; x < raster.size().width; ++x) {
      if (raster.is_valid(y, x)) body(y, x, raster.planes.front()(y, x));
    }
  }
}

Ends ends_of(const Raster& raster) {
  Ends ends;
  for_each_valid(raster, [&](int, int, float value) {
    ends.low.take(value, 1);
    ends.high.take(value, -1);
  });
  return ends;
}

/// Takes pixels out of the valid ones whose value is such; returns how many.
template <class Such>
std::int64_t mask_out(Raster& raster, Such such) {
  std::int64_t count = 0;
  cv::Mat1b valid = raster.valid.empty() ? cv::Mat1b(raster.size(), 255) : raster.valid;
  for_each_valid(raster, [&](int y, int x, float value) {
    if (!such(value) || !bands_equal(raster, y, x)) return;
    valid(y, x) = 0;
    ++count;
  });
  if (count > 0) raster.valid = valid;
  return count;
}

/// Held by several pixels, and farther from all other values than those are from each other.
bool is_apart(const End& end, const End& other) {
  return end.is_of_several_pixels() &&
         std::abs(end.value - end.next) > std::abs(end.next - other.value);
}

bool is_only_negative(const End& end) {
  return end.is_of_several_pixels() && end.value < 0 && end.next >= 0;
}

/// Whether the value is the largest of its type of whole numbers.
bool is_top_of_type(double value, int depth) {
  return (depth == CV_8U && value == 255) || (depth == CV_16U && value == 65535) ||
         (depth == CV_16S && value == 32767);
}

/// What is expected of the values of a file.
struct Rules {
  double never = 0;          ///< nothing is larger, be it in one pixel
  const char* certain = "";  ///< what such values are, and those for which is_mark holds
  std::function<bool(const End& end, const End& other)> is_mark;
  /// Why the value may be meant as a mark; empty if it is not.
  std::function<std::string(const End& end, const End& other)> doubt;
};

Rules rules_of_maps(const Raster& map, double divisor) {
  constexpr double kMaxDisparity = 1 << 20;  // px
  const int depth = map.depth;
  const double px = std::abs(divisor), width = map.size().width;
  Rules rules;
  rules.never = kMaxDisparity * px;
  rules.certain = "which is no disparity of an image of this width";
  rules.is_mark = [=](const End& end, const End& other) {
    return std::abs(end.value) >= width * px && is_apart(end, other);
  };
  rules.doubt = [=](const End& end, const End&) -> std::string {
    if (is_only_negative(end)) return "the only negative value";
    const bool stands_alone = end.is_of_several_pixels() && end.value - end.next > px;
    return is_top_of_type(end.value, depth) && stands_alone ? "the largest value of its type" : "";
  };
  return rules;
}

Rules rules_of_images(int depth) {
  Rules rules;
  rules.never = 1e30;
  rules.certain = "which is no grey level";
  rules.is_mark = [](const End& end, const End& other) {
    return end.value < 0 && is_apart(end, other);
  };
  rules.doubt = [depth](const End& end, const End& other) -> std::string {
    if (is_only_negative(end)) return "the only negative value";
    const bool is_large = depth == CV_16U ? is_top_of_type(end.value, depth) : end.value > 255;
    return is_large && is_apart(end, other) ? "far above all others" : "";
  };
  return rules;
}

std::string pixels_hold(const Raster& raster, std::int64_t pixels, const std::string& what) {
  return raster.file + ": " + std::to_string(pixels) + " of " +
         std::to_string(raster.size().area()) + " pixels hold " + what;
}

std::string taken_for_none(const Rules& rules) {
  return std::string(", ") + rules.certain + ": they are taken for pixels without data";
}

/// Those too large to be anything. There may be many different ones; the warning names one.
void mask_impossible(Raster& raster, const Rules& rules, std::vector<std::string>& warnings) {
  double example = 0;
  const std::int64_t pixels = mask_out(raster, [&](float value) {
    if (std::abs(value) <= rules.never) return false;
    example = value;
    return true;
  });
  if (pixels == 0) return;
  const std::string what = "values such as " + short_number(example);
  warnings.push_back(pixels_hold(raster, pixels, what) + taken_for_none(rules));
}

std::vector<std::string> mask_marks(Raster& raster, const Rules& rules) {
  constexpr int kMostMarks = 8;  // in one file
  std::vector<std::string> warnings;
  mask_impossible(raster, rules, warnings);
  for (int i = 0; i < kMostMarks; ++i) {
    const Ends ends = ends_of(raster);
    const bool low = rules.is_mark(ends.low, ends.high);
    if (!low && !rules.is_mark(ends.high, ends.low)) break;
    const double mark = low ? ends.low.value : ends.high.value;
    const std::int64_t pixels = mask_out(raster, [mark](float value) { return value == mark; });
    if (pixels == 0) break;  // not in all bands
    warnings.push_back(pixels_hold(raster, pixels, short_number(mark)) + taken_for_none(rules));
  }
  const Ends ends = ends_of(raster);
  for (const auto& [end, other] : {std::pair(ends.low, ends.high), {ends.high, ends.low}}) {
    const std::string why = rules.doubt(end, other);
    if (why.empty()) continue;
    warnings.push_back(pixels_hold(raster, end.pixels, short_number(end.value)) + ", " + why +
                       "; if it means that there is no data, say so (--nodata, for the truth "
                       "--truth-nodata; in a dataset.yaml no_data, truth_no_data)");
  }
  return warnings;
}

}  // namespace

std::vector<std::string> mask_marks_of_map(Raster& map, double divisor) {
  return mask_marks(map, rules_of_maps(map, divisor));
}

std::vector<std::string> mask_marks_of_image(Raster& image) {
  if (image.depth == CV_8U) return {};
  return mask_marks(image, rules_of_images(image.depth));
}

}  // namespace xgm
