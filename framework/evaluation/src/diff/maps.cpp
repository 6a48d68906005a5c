// SPDX-License-Identifier: Apache-2.0
// Two disparity maps, pixel by pixel.
#include <algorithm>
#include <cmath>
#include <limits>

#include "xgm/base/error.hpp"
#include "xgm/evaluation/run_diff.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/io/sampling.hpp"

namespace xgm {
namespace {

constexpr int kSide = 32;  // of the squares in which differences are counted, px
constexpr std::size_t kPlaces = 5;

enum class Kind { same, moved, only_first, only_second };

Kind compare(float first, float second, double threshold) {
  const bool has_first = std::isfinite(first), has_second = std::isfinite(second);
  if (has_first != has_second) return has_first ? Kind::only_first : Kind::only_second;
  return has_first && std::abs(double{first} - second) > threshold ? Kind::moved : Kind::same;
}

std::string size_text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

/// Counts all that differs within one square into the sums of the whole, and into its own.
DifferentPlace compare_square(const cv::Mat1f& first, const cv::Mat1f& second, double threshold,
                              const cv::Rect& square, MapDifference& sums) {
  DifferentPlace place{.square = square};
  for (int y = square.y; y < square.br().y; ++y) {
    for (int x = square.x; x < square.br().x; ++x) {
      const Kind kind = compare(first(y, x), second(y, x), threshold);
      if (kind == Kind::moved) ++sums.moved;
      if (kind == Kind::only_first) ++sums.only_first;
      if (kind == Kind::only_second) ++sums.only_second;
      if (kind == Kind::moved) {
        place.largest = std::max(place.largest, std::abs(double{first(y, x)} - second(y, x)));
      }
      if (kind == Kind::same) continue;
      ++place.pixels;
      sums.box |= cv::Rect(x, y, 1, 1);
    }
  }
  return place;
}

/// Mean and largest difference of the pixels that have two disparities.
void compare_disparities(const cv::Mat1f& first, const cv::Mat1f& second, MapDifference& sums) {
  double sum = 0;
  std::int64_t count = 0;
  for (int y = 0; y < first.rows; ++y) {
    for (int x = 0; x < first.cols; ++x) {
      const double difference = std::abs(double{first(y, x)} - second(y, x));
      if (!std::isfinite(difference)) continue;
      sum += difference;
      ++count;
      sums.largest = std::max(sums.largest, difference);
    }
  }
  if (count > 0) sums.mean = sum / static_cast<double>(count);
}

}  // namespace

MapDifference compare_maps(const cv::Mat1f& first, const cv::Mat1f& second, double threshold) {
  if (first.size() != second.size()) {
    throw Error("maps of " + size_text(first.size()) + " and " + size_text(second.size()) +
                " px cannot be compared");
  }
  MapDifference sums{.pixels = static_cast<std::int64_t>(first.total())};
  const cv::Rect whole({0, 0}, first.size());
  for (int y = 0; y < whole.height; y += kSide) {
    for (int x = 0; x < whole.width; x += kSide) {
      const DifferentPlace place =
          compare_square(first, second, threshold, cv::Rect(x, y, kSide, kSide) & whole, sums);
      if (place.pixels > 0) sums.worst.push_back(place);
    }
  }
  std::ranges::stable_sort(sums.worst, [](const DifferentPlace& a, const DifferentPlace& b) {
    return a.pixels != b.pixels ? a.pixels > b.pixels : a.largest > b.largest;
  });
  sums.worst.resize(std::min(sums.worst.size(), kPlaces));
  compare_disparities(first, second, sums);
  return sums;
}

cv::Mat3b difference_picture(const cv::Mat1f& first, const cv::Mat1f& second, double threshold) {
  cv::Mat1f moved(first.size(), std::numeric_limits<float>::quiet_NaN());
  for (int y = 0; y < first.rows; ++y) {
    for (int x = 0; x < first.cols; ++x) {
      if (compare(first(y, x), second(y, x), threshold) == Kind::moved)
        moved(y, x) = std::abs(first(y, x) - second(y, x));
    }
  }
  cv::Mat3b picture = colour_picture(moved, "px");
  const cv::Vec3b white(255, 255, 255), grey(128, 128, 128);
  const Sampling sampling = Sampling::of_picture(first.size());
  for (int y = 0; y < sampling.shown().height; ++y) {
    for (int x = 0; x < sampling.shown().width; ++x) {
      const cv::Point p = sampling.at(x, y);
      const Kind kind = compare(first(p), second(p), threshold);
      if (kind == Kind::only_first) picture(y, x) = white;
      if (kind == Kind::only_second) picture(y, x) = grey;
    }
  }
  return picture;
}

}  // namespace xgm
