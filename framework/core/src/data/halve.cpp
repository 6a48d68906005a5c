// SPDX-License-Identifier: Apache-2.0
// 2x2 means of images, 2x2 hulls of ranges.
#include "xgm/data/halve.hpp"

#include <algorithm>

#include "xgm/base/parallel.hpp"

namespace xgm {
namespace {

int half_up(int n) { return n / 2 + n % 2; }
cv::Size half_up(cv::Size size) { return {half_up(size.width), half_up(size.height)}; }

/// Calls visit(y, x) for the fine pixels inside `size` that coarse pixel (y, x) covers.
template <class Visit>
void for_each_covered(cv::Size size, int coarse_y, int coarse_x, const Visit& visit) {
  const int y_end = std::min(size.height, 2 * coarse_y + 2);
  const int x_end = std::min(size.width, 2 * coarse_x + 2);
  for (int y = 2 * coarse_y; y < y_end; ++y) {
    for (int x = 2 * coarse_x; x < x_end; ++x) visit(y, x);
  }
}

/// Mean of the valid fine pixels that a coarse pixel covers, 0 if there are none.
float mean_of_covered(const cv::Mat1f& fine, const Image& image, int y, int x) {
  float sum = 0;
  int voters = 0;
  for_each_covered(fine.size(), y, x, [&](int fine_y, int fine_x) {
    if (!image.is_valid(fine_y, fine_x)) return;
    sum += fine(fine_y, fine_x);
    ++voters;
  });
  return voters == 0 ? 0.F : sum / static_cast<float>(voters);
}

/// The same for the first n coarse pixels of a row, which cover four pixels each, all valid.
void means_of_four(const float* upper, const float* lower, int n, float* coarse) {
  for (int x = 0; x < n; ++x) {
    const float sum = 0.F + upper[2 * x] + upper[2 * x + 1] + lower[2 * x] + lower[2 * x + 1];
    coarse[x] = sum / 4;
  }
}

cv::Mat1f halve(const cv::Mat1f& fine, const Image& image) {
  cv::Mat1f coarse(half_up(fine.size()));
  parallel_for(0, coarse.rows, [&](int y) {
    const bool simple = image.valid.empty() && 2 * y + 1 < fine.rows;
    const int whole = simple ? fine.cols / 2 : 0;
    if (simple) means_of_four(fine[2 * y], fine[2 * y + 1], whole, coarse[y]);
    for (int x = whole; x < coarse.cols; ++x) coarse(y, x) = mean_of_covered(fine, image, y, x);
  });
  return coarse;
}

cv::Mat1b halve(const cv::Mat1b& fine) {
  cv::Mat1b coarse(half_up(fine.size()), std::uint8_t{0});
  parallel_for(0, coarse.rows, [&](int y) {
    for (int x = 0; x < coarse.cols; ++x) {
      for_each_covered(fine.size(), y, x, [&](int fine_y, int fine_x) {
        coarse(y, x) = std::max(coarse(y, x), fine(fine_y, fine_x));
      });
    }
  });
  return coarse;
}

// Shifting right rounds down, also below zero.
Interval halve(Interval fine) {
  if (fine.empty()) return {};
  return {fine.begin >> 1, (fine.end >> 1) + 1};  // last = end - 1, and ceil(last / 2) = end >> 1
}

}  // namespace

Image halve(const Image& fine) {
  Image coarse;
  for (const cv::Mat1f& plane : fine.planes) coarse.planes.push_back(halve(plane, fine));
  if (!fine.valid.empty()) coarse.valid = halve(fine.valid);
  return coarse;
}

DisparityRange halve(const DisparityRange& fine) {
  const cv::Size size = half_up(fine.size());
  if (fine.is_uniform()) return DisparityRange::uniform(size, halve(fine.hull()));
  return DisparityRange::of_pixels(size, [&](int y, int x) {
    Interval all;
    for_each_covered(fine.size(), y, x,
                     [&](int fine_y, int fine_x) { all = unite(all, fine.at(fine_y, fine_x)); });
    return halve(all);
  });
}

MatchRequest halve(const MatchRequest& fine) {
  MatchRequest coarse{{halve(fine.pair.base), halve(fine.pair.match), fine.pair.is_reverse},
                      halve(fine.range),
                      std::nullopt};
  if (fine.reverse_range) coarse.reverse_range = halve(*fine.reverse_range);
  return coarse;
}

}  // namespace xgm
