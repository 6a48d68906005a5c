// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <functional>

#include "io/raster.hpp"
#include "xgm/data/ground_truth.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm {
namespace {

constexpr int kValues = 256;

/// The largest band; 255 for nonzero values of depths other than 8 bit.
cv::Mat1b largest_band(const Raster& raster) {
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

std::array<bool, kValues> values_of(const cv::Mat1b& mask) {
  std::array<bool, kValues> held{};
  for (const std::uint8_t value : mask) held[value] = true;
  return held;
}

/// "0, 1, 2, 7": the first few.
std::string list(const std::array<bool, kValues>& held) {
  constexpr int kMostListed = 6;
  std::string text;
  int listed = 0;
  for (int value = 0; value < kValues; ++value) {
    if (!held[static_cast<std::size_t>(value)]) continue;
    if (listed++ == kMostListed) return text + ", ...";
    text += (text.empty() ? "" : ", ") + std::to_string(value);
  }
  return text;
}

/// What is to be said of values that the use does not know; empty if there are none.
std::string doubt(std::array<bool, kValues> held, MaskUse use) {
  constexpr int kHidden = 128;  // in masks of Middlebury
  const std::string values = "holds the values " + list(held);
  held[0] = held[kJudged] = false;
  if (use == MaskUse::judged) held[kHidden] = false;
  if (use == MaskUse::objects || std::none_of(held.begin(), held.end(), std::identity())) return {};
  return use == MaskUse::usable
             ? values + ", not 0 and 255: all but 0 are taken for pixels that may be used"
             : values + ", not 0, 128 and 255: only 255 is taken for pixels to judge by";
}

bool is_of_zeros_and_ones(const std::array<bool, kValues>& held) {
  return held[1] && std::none_of(held.begin() + 2, held.end(), std::identity());
}

}  // namespace

Noted<cv::Mat1b> read_mask(const std::string& file, MaskUse use) {
  const Raster raster = read_raster(file);
  Noted<cv::Mat1b> read{largest_band(raster), {}};
  cv::Mat1b& mask = read.value;
  if (!raster.valid.empty()) {
    const cv::Mat1b without_data(raster.valid == 0);
    if (cv::countNonZero(mask & without_data) > 0) {
      read.warnings.push_back(file +
                              ": has pixels without data (alpha 0, NaN or GDAL_NODATA) whose value "
                              "is not 0: they are taken for 0");
    }
    mask.setTo(0, without_data);
  }
  const std::array<bool, kValues> held = values_of(mask);
  if (use != MaskUse::objects && is_of_zeros_and_ones(held)) {
    read.warnings.push_back(file + ": holds the values 0 and 1: 1 is taken for 255");
    mask *= kJudged;
  } else if (const std::string text = doubt(held, use); !text.empty()) {
    read.warnings.push_back(file + ": " + text);
  }
  return read;
}

}  // namespace xgm
