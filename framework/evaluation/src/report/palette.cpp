// SPDX-License-Identifier: Apache-2.0
#include "report/palette.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "xgm/io/outputs.hpp"

namespace xgm::report {
namespace {

Ramp ramp_of(int colour_map) {
  cv::Mat1b levels(1, 256);
  for (int i = 0; i < 256; ++i) levels(0, i) = static_cast<uchar>(i);
  cv::Mat3b colours;
  cv::applyColorMap(levels, colours, colour_map);
  Ramp ramp;
  std::copy(colours.begin(), colours.end(), ramp.begin());
  return ramp;
}

}  // namespace

const Ramp& disparity_ramp() {
  static const Ramp ramp = ramp_of(cv::COLORMAP_VIRIDIS);
  return ramp;
}

const Ramp& error_ramp() {
  static const Ramp ramp = ramp_of(cv::COLORMAP_INFERNO);
  return ramp;
}

const std::vector<Class>& status_classes() {
  static const std::vector<Class> classes = [] {
    std::vector<Class> all;
    for (int i = 0; i < kStatusCount; ++i) {
      const auto status = static_cast<Status>(i);
      all.push_back({std::string(to_string(status)), status_colour(status)});
    }
    return all;
  }();
  return classes;
}

const std::vector<Class>& bad_classes() {
  static const std::vector<Class> classes{{"good", {238, 238, 238}},
                                          {"bad", {0, 94, 213}},
                                          {"no disparity", {120, 50, 0}},
                                          {"not judged", {160, 160, 160}}};
  return classes;
}

Span colour_span(const std::vector<cv::Mat1f>& maps) {
  std::vector<float> values;
  for (const cv::Mat1f& map : maps) {
    std::copy_if(map.begin(), map.end(), std::back_inserter(values),
                 [](float value) { return std::isfinite(value); });
  }
  if (values.empty()) return {};
  const auto quantile = [&](double share) {
    const auto rank = std::lround(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return static_cast<double>(values[static_cast<std::size_t>(rank)]);
  };
  const Span span{quantile(0.01), quantile(0.99)};
  return span.high > span.low ? span : Span{span.low - 0.5, span.low + 0.5};
}

cv::Vec3b colour_at(const Ramp& ramp, const Span& span, double value) {
  if (!std::isfinite(value)) return kNoNumber;
  const double share = std::clamp((value - span.low) / (span.high - span.low), 0.0, 1.0);
  return ramp[static_cast<std::size_t>(std::lround(255 * share))];
}

std::string css(const cv::Vec3b& colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", colour[2], colour[1], colour[0]);
  return text;
}

}  // namespace xgm::report
