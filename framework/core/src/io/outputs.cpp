// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/outputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace xgm {
namespace {

const cv::Scalar kInk(255, 255, 255);
constexpr int kLegendWidth = 320;  // narrower pictures are widened to this
constexpr int kLine = 22;          // height of a line of text
constexpr int kMargin = 8;

/// Colours that colour-blind readers can tell apart (Okabe and Ito 2008), in the order of Status.
const std::array<cv::Vec3b, kStatusCount> kStatusColours = {
    cv::Vec3b(115, 158, 0), cv::Vec3b(233, 180, 86), cv::Vec3b(60, 60, 60),
    cv::Vec3b(0, 0, 0),     cv::Vec3b(66, 228, 240), cv::Vec3b(178, 114, 0),
    cv::Vec3b(0, 94, 213),  cv::Vec3b(167, 121, 204)};

/// Legends grow with the picture, so that they can be read when it is shown as a whole.
int legend_scale(int width) { return std::max(1, width / 800); }

/// A black canvas with `picture` at the top left and room for `lines` lines of text below.
cv::Mat3b with_room_below(const cv::Mat3b& picture, int lines, int scale) {
  const int height = scale * (lines * kLine + 2 * kMargin);
  cv::Mat3b canvas(picture.rows + height, std::max(picture.cols, kLegendWidth), cv::Vec3b());
  picture.copyTo(canvas(cv::Rect({}, picture.size())));
  return canvas;
}

void write(cv::Mat3b& canvas, const std::string& text, cv::Point left_bottom, int scale) {
  cv::putText(canvas, text, left_bottom, cv::FONT_HERSHEY_SIMPLEX, 0.45 * scale, kInk, scale,
              cv::LINE_AA);
}

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

struct Span {
  float low = 0;
  float high = 1;
};

/// Nearly all disparities lie in the span; a few wrong ones do not wash out the rest.
Span colour_span(const DisparityMap& map) {
  std::vector<float> values;
  for (int y = 0; y < map.size().height; ++y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (map.has_disparity(y, x)) values.push_back(map.disparity(y, x));
    }
  }
  if (values.empty()) return {};
  const auto quantile = [&](double share) {
    const auto rank = std::lround(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
  };
  const Span span{quantile(0.01), quantile(0.99)};
  return span.high > span.low ? span : Span{span.low - 0.5f, span.low + 0.5f};
}

cv::Mat3b in_turbo(const cv::Mat1b& levels) {
  cv::Mat3b colours;
  cv::applyColorMap(levels, colours, cv::COLORMAP_TURBO);
  return colours;
}

/// A colour bar with five numbers: where on the bar a number stands is where its value lies.
void draw_bar(cv::Mat3b& canvas, int top, const Span& span, int scale) {
  const int margin = kMargin * scale;
  cv::Mat1b ramp(kLine * scale, canvas.cols - 2 * margin);
  for (int x = 0; x < ramp.cols; ++x) {
    ramp.col(x) = cv::saturate_cast<uchar>(255.0 * x / std::max(1, ramp.cols - 1));
  }
  in_turbo(ramp).copyTo(canvas(cv::Rect({margin, top + margin}, ramp.size())));
  constexpr int kSteps = 4;
  for (int i = 0; i <= kSteps; ++i) {
    const double value = span.low + (span.high - span.low) * static_cast<double>(i) / kSteps;
    const std::string text = format(i == kSteps ? "%.1f px" : "%.1f", value);
    const int width =
        cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 0.45 * scale, scale, nullptr).width;
    const int centre = margin + ramp.cols * i / kSteps;
    const int left = std::clamp(centre - width / 2, margin, canvas.cols - margin - width);
    write(canvas, text, {left, top + margin + (2 * kLine - 6) * scale}, scale);
  }
}

}  // namespace

cv::Mat3b disparity_picture(const DisparityMap& map) {
  const Span span = colour_span(map);
  cv::Mat1b levels(map.size(), uchar{0});
  cv::Mat1b missing(map.size(), uchar{0});
  for (int y = 0; y < levels.rows; ++y) {
    for (int x = 0; x < levels.cols; ++x) {
      missing(y, x) = map.has_disparity(y, x) ? 0 : 255;
      if (missing(y, x)) continue;
      const float share = (map.disparity(y, x) - span.low) / (span.high - span.low);
      levels(y, x) = cv::saturate_cast<uchar>(255 * share);
    }
  }
  cv::Mat3b colours = in_turbo(levels);
  colours.setTo(cv::Scalar(), missing);
  const int scale = legend_scale(map.size().width);
  cv::Mat3b canvas = with_room_below(colours, 2, scale);
  if (map.density() > 0) {
    draw_bar(canvas, colours.rows, span, scale);
  } else {
    write(canvas, "no disparity anywhere", {kMargin, colours.rows + kLine * scale}, scale);
  }
  return canvas;
}

cv::Vec3b status_colour(Status status) { return kStatusColours[static_cast<std::size_t>(status)]; }

cv::Mat3b status_picture(const DisparityMap& map) {
  cv::Mat3b colours(map.size());
  for (int y = 0; y < colours.rows; ++y) {
    for (int x = 0; x < colours.cols; ++x) colours(y, x) = kStatusColours[map.status(y, x)];
  }
  const int scale = legend_scale(map.size().width);
  const auto shares = status_shares(map);
  constexpr int kColumns = 2;
  cv::Mat3b canvas = with_room_below(colours, (kStatusCount + 1) / kColumns, scale);
  for (int i = 0; i < kStatusCount; ++i) {
    const int left = kMargin * scale + i % kColumns * (kLegendWidth / kColumns * scale);
    const int top = colours.rows + (kMargin + i / kColumns * kLine) * scale;
    const cv::Rect box(left, top + 4 * scale, 12 * scale, 12 * scale);
    cv::rectangle(canvas, box, cv::Scalar(kStatusColours[static_cast<std::size_t>(i)]), cv::FILLED);
    cv::rectangle(canvas, box, kInk, 1);  // black and dark boxes would not be seen
    const std::string name(to_string(static_cast<Status>(i)));
    const double share = 100 * shares[static_cast<std::size_t>(i)];
    write(canvas, name + format(" %.1f %%", share), {left + 18 * scale, top + 15 * scale}, scale);
  }
  return canvas;
}

cv::Mat3b picture(const Image& image) {
  std::vector<cv::Mat1b> levels;
  for (int c = 0; c < 3; ++c) {
    const cv::Mat1f& plane =
        image.planes[image.planes.size() == 3 ? static_cast<std::size_t>(c) : 0];
    plane.convertTo(levels.emplace_back(), CV_8U);
  }
  cv::Mat3b result;
  cv::merge(levels, result);
  if (!image.valid.empty()) result.setTo(cv::Scalar(), image.valid == 0);
  return result;
}

std::array<double, kStatusCount> status_shares(const DisparityMap& map) {
  std::array<double, kStatusCount> shares{};
  for (int i = 0; i < kStatusCount; ++i) {
    const auto total = static_cast<double>(map.status.total());
    shares[static_cast<std::size_t>(i)] = total > 0 ? cv::countNonZero(map.status == i) / total : 0;
  }
  return shares;
}

}  // namespace xgm
