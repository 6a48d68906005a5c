// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <functional>

#include "io/mask_values.hpp"
#include "xgm/data/ground_truth.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm {
namespace {

/// The largest band; 255 for nonzero values of depths other than 8 bit.
cv::Mat1b largest_band(const UnscaledImage& raster) {
  cv::Mat1f largest = raster.planes.front();
  for (const cv::Mat1f& plane : raster.planes) largest = cv::max(largest, plane);
  cv::Mat1b mask;
  if (raster.depth == CV_8U) {
    largest.convertTo(mask, CV_8U);
  } else {
    mask = largest != 0;
  }
  return mask;
}

/// "0, 1, 2, 7": the first few.
std::string list(const MaskValues::Held& held) {
  constexpr int kMostListed = 6;
  std::string text;
  int listed = 0;
  for (int value = 0; value < MaskValues::kCount; ++value) {
    if (!held[static_cast<std::size_t>(value)]) continue;
    if (listed++ == kMostListed) return text + ", ...";
    text += (text.empty() ? "" : ", ") + std::to_string(value);
  }
  return text;
}

/// What is to be said of values that the use does not know; empty if there are none.
std::string doubt(MaskValues::Held held, MaskUse use) {
  constexpr int kHidden = 128;  // in masks of Middlebury
  const std::string values = "holds the values " + list(held);
  held[0] = held[kJudged] = false;
  if (use == MaskUse::judged) held[kHidden] = false;
  if (use == MaskUse::objects || std::none_of(held.begin(), held.end(), std::identity())) return {};
  return use == MaskUse::usable
             ? values + ", not 0 and 255: all but 0 are taken for pixels that may be used"
             : values + ", not 0, 128 and 255: only 255 is taken for pixels to judge by";
}

}  // namespace

cv::Mat1b MaskValues::add(const UnscaledImage& part) {
  cv::Mat1b mask = largest_band(part);
  if (!part.valid.empty()) {
    const cv::Mat1b without_data(part.valid == 0);
    lost_ = lost_ || cv::countNonZero(mask & without_data) > 0;
    mask.setTo(0, without_data);
  }
  for (const std::uint8_t value : mask) held_[value] = true;
  return mask;
}

bool MaskValues::are_zeros_and_ones() const {
  return held_[1] && std::none_of(held_.begin() + 2, held_.end(), std::identity());
}

std::vector<std::string> MaskValues::warnings(const std::string& file, MaskUse use) const {
  std::vector<std::string> texts;
  if (lost_) {
    texts.push_back(file +
                    ": has pixels without data (alpha 0, NaN or GDAL_NODATA) whose value is not 0: "
                    "they are taken for 0");
  }
  if (use != MaskUse::objects && are_zeros_and_ones()) {
    texts.push_back(file + ": holds the values 0 and 1: 1 is taken for 255");
  } else if (const std::string text = doubt(held_, use); !text.empty()) {
    texts.push_back(file + ": " + text);
  }
  return texts;
}

Noted<cv::Mat1b> read_mask(const std::string& file, MaskUse use) {
  MaskValues values;
  Noted<cv::Mat1b> read{values.add(read_unscaled(file)), {}};
  if (use != MaskUse::objects && values.are_zeros_and_ones()) read.value *= kJudged;
  read.warnings = values.warnings(file, use);
  return read;
}

}  // namespace xgm
