// SPDX-License-Identifier: Apache-2.0
// The colours of the page; all can be told apart by colour-blind readers.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "xgm/data/disparity_map.hpp"

namespace xgm::report {

/// 256 colours whose luminance only rises, blue-green-red.
using Ramp = std::array<cv::Vec3b, 256>;
const Ramp& disparity_ramp();  ///< viridis
const Ramp& error_ramp();      ///< inferno

/// Where numbers have none.
inline const cv::Vec3b kNoNumber{200, 200, 200};

struct Class {
  std::string name;
  cv::Vec3b colour;
};
/// One per Status.
const std::vector<Class>& status_classes();

/// How a pixel compares with the truth, in the order of bad_classes().
enum class Verdict : std::uint8_t { good, bad, no_disparity, not_judged };
const std::vector<Class>& bad_classes();

/// Errors are shown up to this, px.
inline constexpr double kErrorSpan = 4;

/// Values that a ramp spans, px.
struct Span {
  double low = 0;
  double high = 1;
};
/// Nearly all finite numbers of the maps lie in it; a few wrong ones do not wash out the rest.
Span colour_span(const std::vector<cv::Mat1f>& maps);

cv::Vec3b colour_at(const Ramp& ramp, const Span& span, double value);
/// "#rrggbb"
std::string css(const cv::Vec3b& colour);

}  // namespace xgm::report
