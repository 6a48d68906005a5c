// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/image/resample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::geo {
namespace {

/// Weights of the four samples around a place that lies `t` behind the second.
std::array<double, 4> cubic_weights(double t) {
  const double u = 1 - t;
  return {-0.5 * t * u * u, 1 + t * t * (1.5 * t - 2.5), 1 + u * u * (1.5 * u - 2.5),
          -0.5 * u * t * t};
}

/// NaN where a sample is missing.
float sample(const cv::Mat1f& image, cv::Point2d place) {
  const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
  if (x < 1 || y < 1 || x + 2 >= image.cols || y + 2 >= image.rows) {
    return std::numeric_limits<float>::quiet_NaN();
  }
  const auto across = cubic_weights(place.x - x), down = cubic_weights(place.y - y);
  double sum = 0;
  for (int j = 0; j < 4; ++j) {
    const float* const row = image[y - 1 + j] + x - 1;
    double line = 0;
    for (int i = 0; i < 4; ++i) line += across[static_cast<std::size_t>(i)] * double{row[i]};
    sum += down[static_cast<std::size_t>(j)] * line;
  }
  return static_cast<float>(sum);
}

using Map = std::function<cv::Point2d(cv::Point2d)>;

/// The part of the image that a rectified image shows, and the samples around it.
cv::Rect shown(cv::Size size, const Map& to_image, cv::Size image_size) {
  constexpr int kSteps = 64;
  cv::Point2d low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
  for (int k = 0; k <= kSteps; ++k) {
    const double x = (size.width - 1) * k / double{kSteps};
    const double y = (size.height - 1) * k / double{kSteps};
    for (const cv::Point2d border : {cv::Point2d(x, 0), cv::Point2d(x, size.height - 1.0),
                                     cv::Point2d(0, y), cv::Point2d(size.width - 1.0, y)}) {
      const cv::Point2d p = to_image(border);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  constexpr double kAround = 4;
  const cv::Rect2d box(low - cv::Point2d(kAround, kAround), high + cv::Point2d(kAround, kAround));
  const cv::Rect2d inside = box & cv::Rect2d({}, cv::Size2d(image_size));
  return {cvFloor(inside.x), cvFloor(inside.y), cvCeil(inside.width) + 1,
          cvCeil(inside.height) + 1};
}

Image resample(const SatelliteImage& image, const GreyScale& scale, cv::Size size,
               const Map& to_image) {
  Image result(cv::Mat1f(size, 0.0F));
  result.valid = cv::Mat1b(size, static_cast<std::uint8_t>(0));
  const cv::Rect window = shown(size, to_image, image.size) & cv::Rect({}, image.size);
  if (window.empty()) return result;
  const cv::Mat1f source = read_window(image, window);
  const cv::Point2d origin = window.tl();
  const double gain = 255 / std::max(scale.white - scale.black, 1e-9);
  parallel_for(0, size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      const float grey = sample(source, to_image(cv::Point2d(x, y)) - origin);
      if (std::isnan(grey)) continue;
      result.valid(y, x) = 255;
      result.planes.front()(y, x) =
          static_cast<float>(std::clamp((double{grey} - scale.black) * gain, 0.0, 255.0));
    }
  });
  return result;
}

}  // namespace

GreyScale find_grey_scale(const SatelliteImage& image, double tail) {
  // Some rows are enough; together they have a million pixels at most.
  constexpr int kRows = 200;
  std::vector<float> greys;
  const int step = std::max(1, image.size.height / kRows);
  const int stride = std::max(1, image.size.width / 5000);
  for (int y = step / 2; y < image.size.height; y += step) {
    const cv::Mat1f row = read_window(image, {0, y, image.size.width, 1});
    for (int x = 0; x < row.cols; x += stride) {
      if (!std::isnan(row(0, x))) greys.push_back(row(0, x));
    }
  }
  if (greys.empty()) throw Error(image.file + ": no pixel of this image has data");
  const auto at = [&](double share) {
    const auto place =
        greys.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(greys.size() - 1));
    std::nth_element(greys.begin(), place, greys.end());
    return double{*place};
  };
  return {at(tail), at(1 - tail)};
}

ImagePair resample(const RectifiedPair& pair, const GreyScale& base, const GreyScale& match) {
  const Rectification& geometry = *pair.geometry;
  ImagePair result;
  result.base = resample(pair.base, base, geometry.size(),
                         [&](cv::Point2d p) { return geometry.to_base(p); });
  result.match = resample(pair.match, match, geometry.size(),
                          [&](cv::Point2d p) { return geometry.to_match(p); });
  return result;
}

}  // namespace xgm::geo
