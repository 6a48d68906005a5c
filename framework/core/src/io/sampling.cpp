// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/sampling.hpp"

namespace xgm {

Sampling Sampling::within(cv::Size full, double pixels) {
  Sampling sampling{full, 1};
  const auto fits = [&] {
    const cv::Size shown = sampling.shown();
    return shown.area() <= std::max(1.0, pixels) && std::max(shown.width, shown.height) <= kMaxSide;
  };
  while (!fits()) ++sampling.stride;
  return sampling;
}

Sampling Sampling::of_picture(cv::Size full) {
  constexpr double kMaxPixels = 1 << 26;  // 200 MB while it is drawn
  return within(full, kMaxPixels);
}

}  // namespace xgm
