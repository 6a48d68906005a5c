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
constexpr int kColumns = 2;  // of the statuses' names
constexpr int kStatusLines = (kStatusCount + 1) / kColumns;

/// Colours that colour-blind readers can tell apart (Okabe and Ito 2008), in the order of Status.
const std::array<cv::Vec3b, kStatusCount> kStatusColours = {
    cv::Vec3b(115, 158, 0), cv::Vec3b(233, 180, 86), cv::Vec3b(60, 60, 60),
    cv::Vec3b(0, 0, 0),     cv::Vec3b(66, 228, 240), cv::Vec3b(178, 114, 0),
    cv::Vec3b(0, 94, 213),  cv::Vec3b(167, 121, 204)};

/// A picture of so many pixels at the top left, and a legend of so many lines below.
struct Layout {
  cv::Size picture;
  int lines;

  /// Legends grow with the picture, so that they can be read when it is shown as a whole; those of
  /// strips do not become taller than the picture.
  int scale() const {
    return std::max(1, std::min(picture.width / 800, picture.height / height()));
  }
  cv::Size size() const {
    return {std::max(picture.width, kLegendWidth), picture.height + scale() * height()};
  }
  cv::Mat3b canvas() const { return cv::Mat3b(size(), cv::Vec3b()); }

 private:
  int height() const { return lines * kLine + 2 * kMargin; }
};

void write(cv::Mat3b& canvas, const std::string& text, cv::Point left_bottom, int scale) {
  cv::putText(canvas, text, left_bottom, cv::FONT_HERSHEY_SIMPLEX, 0.45 * scale, kInk, scale,
              cv::LINE_AA);
}

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/// Calls body(y, x, pixel) for each pixel of the picture, with the one of the map that it shows.
template <class Body>
void each_shown(const Sampling& sampling, const Body& body) {
  const cv::Size size = sampling.shown();
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) body(y, x, sampling.at(x, y));
  }
}

struct Span {
  float low = 0;
  float high = 1;
};

/// Nearly all values shown lie in the span; a few wrong ones do not wash out the rest.
Span colour_span(const cv::Mat1f& map, const Sampling& sampling) {
  std::vector<float> values;
  each_shown(sampling, [&](int, int, cv::Point p) {
    if (!std::isnan(map(p))) values.push_back(map(p));
  });
  if (values.empty()) return {};
  const auto quantile = [&](double share) {
    const auto rank = std::lround(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
  };
  const Span span{quantile(0.01), quantile(0.99)};
  return span.high > span.low ? span : Span{span.low - 0.5f, span.low + 0.5f};
}

/// The 256 colours of "turbo", from far to near.
cv::Mat3b turbo_colours() {
  cv::Mat1b levels(1, 256);
  for (int i = 0; i < levels.cols; ++i) levels(0, i) = static_cast<uchar>(i);
  cv::Mat3b colours;
  cv::applyColorMap(levels, colours, cv::COLORMAP_TURBO);
  return colours;
}

/// The mean of a block of pixels, black where there are no data.
cv::Vec3b mean_colour(const Image& image, const cv::Rect& block) {
  cv::Vec3f sum;
  for (int y = block.y; y < block.br().y; ++y) {
    for (int x = block.x; x < block.br().x; ++x) {
      if (!image.is_valid(y, x)) continue;
      for (int c = 0; c < 3; ++c) {
        sum[c] += image.planes[image.planes.size() == 3 ? static_cast<std::size_t>(c) : 0](y, x);
      }
    }
  }
  cv::Vec3b mean;
  for (int c = 0; c < 3; ++c) {
    mean[c] = cv::saturate_cast<uchar>(sum[c] / static_cast<float>(block.area()));
  }
  return mean;
}

/// A colour bar with five numbers: where on the bar a number stands is where its value lies.
void draw_bar(cv::Mat3b& canvas, int top, const Span& span, const std::string& unit, int scale) {
  const int margin = kMargin * scale;
  const cv::Mat3b turbo = turbo_colours();
  cv::Mat3b ramp = canvas(cv::Rect(margin, top + margin, canvas.cols - 2 * margin, kLine * scale));
  for (int x = 0; x < ramp.cols; ++x) {
    const auto level = cv::saturate_cast<uchar>(255.0 * x / std::max(1, ramp.cols - 1));
    ramp.col(x).setTo(cv::Scalar(turbo(0, level)));
  }
  constexpr int kSteps = 4;
  for (int i = 0; i <= kSteps; ++i) {
    const double value = span.low + (span.high - span.low) * static_cast<double>(i) / kSteps;
    const std::string text = format("%.1f", value) + (i == kSteps ? " " + unit : "");
    const int width =
        cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 0.45 * scale, scale, nullptr).width;
    const int centre = margin + ramp.cols * i / kSteps;
    const int left = std::clamp(centre - width / 2, margin, canvas.cols - margin - width);
    write(canvas, text, {left, top + margin + (2 * kLine - 6) * scale}, scale);
  }
}

cv::Mat3b empty_picture(cv::Size map) {
  const Layout layout{Sampling::of_picture(map).shown(), 2};
  cv::Mat3b canvas = layout.canvas();
  write(canvas, "no disparity anywhere", {kMargin, layout.picture.height + kLine * layout.scale()},
        layout.scale());
  return canvas;
}

}  // namespace

cv::Mat3b disparity_picture(const DisparityMap& map) {
  return map.density() > 0 ? colour_picture(map.disparity, "px") : empty_picture(map.size());
}

cv::Mat3b colour_picture(const cv::Mat1f& values, const std::string& unit, const cv::Mat1f& light) {
  const Sampling sampling = Sampling::of_picture(values.size());
  const Span span = colour_span(values, sampling);
  const cv::Mat3b turbo = turbo_colours();
  const Layout layout{sampling.shown(), 2};
  cv::Mat3b canvas = layout.canvas();
  each_shown(sampling, [&](int y, int x, cv::Point p) {
    if (std::isnan(values(p))) return;
    const float share = (values(p) - span.low) / (span.high - span.low);
    canvas(y, x) = turbo(0, cv::saturate_cast<uchar>(255 * share));
    if (!light.empty()) canvas(y, x) *= light(p);
  });
  draw_bar(canvas, layout.picture.height, span, unit, layout.scale());
  return canvas;
}

cv::Size picture_size(cv::Size map) {
  return Layout{Sampling::of_picture(map).shown(), kStatusLines}.size();  // the longer legend
}

cv::Vec3b status_colour(Status status) { return kStatusColours[static_cast<std::size_t>(status)]; }

cv::Mat3b status_picture(const DisparityMap& map) {
  return status_picture(map, status_shares(map));
}

cv::Mat3b status_picture(const DisparityMap& map, const std::array<double, kStatusCount>& shares) {
  const Sampling sampling = Sampling::of_picture(map.size());
  const Layout layout{sampling.shown(), kStatusLines};
  cv::Mat3b canvas = layout.canvas();
  each_shown(sampling,
             [&](int y, int x, cv::Point p) { canvas(y, x) = status_colour(map.at(p.y, p.x)); });
  const int scale = layout.scale();
  for (int i = 0; i < kStatusCount; ++i) {
    const int left = kMargin * scale + i % kColumns * (kLegendWidth / kColumns * scale);
    const int top = layout.picture.height + (kMargin + i / kColumns * kLine) * scale;
    const cv::Rect box(left, top + 4 * scale, 12 * scale, 12 * scale);
    cv::rectangle(canvas, box, cv::Scalar(kStatusColours[static_cast<std::size_t>(i)]), cv::FILLED);
    cv::rectangle(canvas, box, kInk, 1);  // black and dark boxes would not be seen
    const std::string name(to_string(static_cast<Status>(i)));
    const double share = 100 * shares[static_cast<std::size_t>(i)];
    write(canvas, name + format(" %.1f %%", share), {left + 18 * scale, top + 15 * scale}, scale);
  }
  return canvas;
}

cv::Mat3b picture(const Image& image) { return picture(image, Sampling{image.size()}); }

cv::Mat3b picture(const Image& image, const Sampling& sampling) {
  cv::Mat3b result(sampling.shown());
  const cv::Rect all({}, image.size());
  const int stride = sampling.stride;
  for (int y = 0; y < result.rows; ++y) {
    for (int x = 0; x < result.cols; ++x) {
      const cv::Rect block = cv::Rect(x * stride, y * stride, stride, stride) & all;
      result(y, x) = mean_colour(image, block);
    }
  }
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
