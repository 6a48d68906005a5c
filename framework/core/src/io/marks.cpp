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

bool bands_equal(const UnscaledImage& raster, int y, int x) {
  const float first = raster.planes.front()(y, x);
  return std::all_of(raster.planes.begin(), raster.planes.end(),
                     [&](const cv::Mat1f& plane) { return plane(y, x) == first; });
}

template <class Body>
void for_each_valid(const UnscaledImage& raster, Body body) {
  for (int y = 0; y < raster.size().height; ++y) {
    for (int x = 0; x < raster.size().width; ++x) {
      if (raster.is_valid(y, x)) body(y, x, raster.planes.front()(y, x));
    }
  }
}

void add_ends(const UnscaledImage& raster, Ends& ends) {
  for_each_valid(raster, [&](int, int, float value) {
    ends.low.take(value, 1);
    ends.high.take(value, -1);
  });
}

/// Takes pixels out of the valid ones whose value is such; returns how many.
template <class Such>
std::int64_t mask_out(UnscaledImage& raster, Such such) {
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

Rules rules_of_maps(const UnscaledImage& map, double divisor) {
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

/// Whether no rule of images finds anything, told by a faster look.
bool holds_plain_levels(const UnscaledImage& image) {
  double low = 0, high = 0;
  cv::minMaxIdx(image.planes.front(), &low, &high, nullptr, nullptr, image.valid);
  return low >= 0 && high <= (image.depth == CV_16U ? 65534 : 255);
}

/// A look at all pixels: those that mean no data are taken out.
struct Look {
  Ends ends{};              ///< of the pixels that are left
  std::int64_t masked = 0;  ///< pixels that this look has taken out, and no earlier one
  double example = 0;       ///< the value of one of them
};

class MarkSearch {
 public:
  MarkSearch(const MarkedFile& file, const Rules& rules) : file_(file), rules_(rules) {}

  FoundMarks run() {
    // There may be many different ones; the warning names one.
    Look look = look_at_all([&](float value) { return std::abs(value) > rules_.never; });
    found_.marks.never = rules_.never;
    if (look.masked > 0) tell_none(look.masked, "values such as " + short_number(look.example));
    for (int i = 0; i < kMostMarks; ++i) {
      const bool low = rules_.is_mark(look.ends.low, look.ends.high);
      if (!low && !rules_.is_mark(look.ends.high, look.ends.low)) break;
      const double mark = low ? look.ends.low.value : look.ends.high.value;
      look = look_at_all([mark](float value) { return value == mark; });
      if (look.masked == 0) break;  // not in all bands
      found_.marks.values.push_back(mark);
      tell_none(look.masked, short_number(mark));
    }
    tell_doubts(look.ends);
    return std::move(found_);
  }

 private:
  static constexpr int kMostMarks = 8;  // in one file

  template <class Such>
  Look look_at_all(const Such& such) const {
    Look look;
    file_.each_part([&](UnscaledImage& part) {
      mask(part, found_.marks);  // they are there again if it was read again
      look.masked += mask_out(part, [&](float value) {
        if (!such(value)) return false;
        look.example = value;
        return true;
      });
      add_ends(part, look.ends);
    });
    return look;
  }

  std::string pixels_hold(std::int64_t pixels, const std::string& what) const {
    return file_.name + ": " + std::to_string(pixels) + " of " + std::to_string(file_.size.area()) +
           " pixels hold " + what;
  }

  void tell_none(std::int64_t pixels, const std::string& what) {
    found_.warnings.push_back(pixels_hold(pixels, what) + ", " + rules_.certain +
                              ": they are taken for pixels without data");
  }

  void tell_doubts(const Ends& ends) {
    for (const auto& [end, other] : {std::pair(ends.low, ends.high), {ends.high, ends.low}}) {
      const std::string why = rules_.doubt(end, other);
      if (why.empty()) continue;
      found_.warnings.push_back(
          pixels_hold(end.pixels, short_number(end.value)) + ", " + why +
          "; if it means that there is no data, say so (--nodata, for the truth --truth-nodata; in "
          "a dataset.yaml no_data, truth_no_data)");
    }
  }

  const MarkedFile& file_;
  const Rules& rules_;
  FoundMarks found_;
};

MarkedFile in_memory(UnscaledImage& raster) {
  return {raster.file, raster.size(), [&raster](const TakeImage& take) { take(raster); }};
}

}  // namespace

void mask(UnscaledImage& raster, const Marks& marks) {
  if (marks.empty()) return;
  mask_out(raster, [&](float value) {
    return std::abs(value) > marks.never ||
           std::find(marks.values.begin(), marks.values.end(), value) != marks.values.end();
  });
}

std::vector<std::string> mask_marks_of_map(UnscaledImage& map, double divisor) {
  return MarkSearch(in_memory(map), rules_of_maps(map, divisor)).run().warnings;
}

FoundMarks marks_of_image(const MarkedFile& file, int depth) {
  if (depth == CV_8U) return {};
  return MarkSearch(file, rules_of_images(depth)).run();
}

std::vector<std::string> mask_marks_of_image(UnscaledImage& image) {
  if (holds_plain_levels(image)) return {};
  return marks_of_image(in_memory(image), image.depth).warnings;
}

}  // namespace xgm
