// SPDX-License-Identifier: Apache-2.0
#include "plugins/consistency/lrrl/pointed_at.hpp"

#include <cmath>
#include <limits>

namespace xgm::lrrl {

void mark_pointed_at(const cv::Mat1f& other, int y, double step, std::uint8_t* marks) {
  const float* const disparities = other[y];
  const int width = other.cols;
  std::fill_n(marks, width + 2, std::uint8_t{0});
  std::uint8_t* const pointed = marks + 1;
  float before = std::numeric_limits<float>::quiet_NaN();  // disparity and target of pixel q - 1
  int last = -1;
  for (int q = 0; q < width; ++q) {
    const float d = disparities[q];
    const int here = target(q, d, width);
    pointed[here] = 1;
    // Rarely is there anything between two targets; NaN compares false.
    if (std::abs(here - last) > 1 &&
        std::abs(static_cast<double>(d) - static_cast<double>(before)) <= step) {
      std::fill(pointed + std::min(here, last), pointed + std::max(here, last), std::uint8_t{1});
    }
    before = d;
    last = here;
  }
}

}  // namespace xgm::lrrl
