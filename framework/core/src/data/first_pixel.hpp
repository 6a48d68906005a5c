// SPDX-License-Identifier: Apache-2.0
// Looks for a pixel that breaks a rule. Nearly always there is none: rows are looked through
// without branches, so that the loop is one of vector instructions.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "xgm/base/parallel.hpp"

namespace xgm {

/// The first pixel, row by row, for which `broken` is true. broken(y) is asked once for each row
/// and returns the question for its pixels, of their x.
template <class Broken>
std::optional<cv::Point> first_pixel(cv::Size size, const Broken& broken) {
  std::vector<char> some(static_cast<std::size_t>(size.height));
  parallel_for(0, size.height, [&](int y) {
    const auto is_broken = broken(y);
    int any = 0;
    for (int x = 0; x < size.width; ++x) any |= static_cast<int>(is_broken(x));
    some[static_cast<std::size_t>(y)] = any != 0;
  });
  const auto row = std::find(some.begin(), some.end(), 1);
  if (row == some.end()) return std::nullopt;
  const int y = static_cast<int>(row - some.begin());
  const auto is_broken = broken(y);
  int x = 0;
  while (!is_broken(x)) ++x;
  return cv::Point(x, y);
}

}  // namespace xgm
