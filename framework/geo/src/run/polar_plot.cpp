// SPDX-License-Identifier: Apache-2.0
#include "run/polar_plot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

#include "xgm/base/text.hpp"
#include "xgm/evaluation/report.hpp"

namespace xgm::geo {
namespace {

constexpr double kRadius = 130, kMargin = 30;  // of the plot, px
constexpr double kMiddle = kRadius + kMargin;
constexpr int kCircles = 3;

std::string at(const char* x, const char* y, cv::Point2d place) {
  return std::string(" ") + x + "=\"" + fixed_number(place.x, 1) + "\" " + y + "=\"" +
         fixed_number(place.y, 1) + "\"";
}

std::string label(cv::Point2d place, const std::string& text) {
  return "<text" + at("x", "y", place) + ">" + html_text(text) + "</text>\n";
}

cv::Point2d place_of(const SkyPoint& point, double outermost) {
  const double angle = point.azimuth * std::numbers::pi / 180;
  const double radius = kRadius * std::min(point.zenith / outermost, 1.0);
  return {kMiddle + radius * std::sin(angle), kMiddle - radius * std::cos(angle)};
}

}  // namespace

std::string polar_plot(const std::string& title, const std::vector<SkyPoint>& points,
                       double outermost) {
  const std::string side = fixed_number(2 * kMiddle, 0);
  std::string svg = "<svg viewBox=\"0 0 " + side + " " + side +
                    "\" width=\"100%\" role=\"img\" aria-label=\"" + html_text(title) +
                    "\" font-size=\"12\" fill=\"currentColor\">\n";
  for (int i = 1; i <= kCircles; ++i) {
    svg += "<circle" + at("cx", "cy", {kMiddle, kMiddle}) + " r=\"" +
           fixed_number(kRadius * i / kCircles, 1) +
           "\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.3\"/>\n" +
           label({kMiddle + 3, kMiddle - kRadius * i / kCircles + 13},
                 fixed_number(outermost * i / kCircles, 0) + "°");
  }
  svg +=
      label({kMiddle - 4, kMargin - 8}, "N") + label({2 * kMiddle - kMargin + 6, kMiddle + 4}, "E");
  svg += label({kMiddle - 4, 2 * kMiddle - kMargin + 18}, "S") +
         label({kMargin - 20, kMiddle + 4}, "W");
  for (const SkyPoint& point : points) {
    const cv::Point2d place = place_of(point, outermost);
    svg += "<circle" + at("cx", "cy", place) + " r=\"4\" fill=\"#0b72b5\"/>\n" +
           label(place + cv::Point2d(7, 4), point.name);
  }
  return "<figure>" + svg + "</svg><figcaption><b>" + html_text(title) +
         "</b></figcaption></figure>\n";
}

}  // namespace xgm::geo
