// SPDX-License-Identifier: Apache-2.0
#include "plugins/consistency/lrrl/pointed_at.hpp"

#include <algorithm>
#include <cmath>

namespace xgm::lrrl {

int target(int x, float disparity) {
  return static_cast<int>(std::floor(x - static_cast<double>(disparity) + 0.5));
}

void mark_pointed_at(const cv::Mat1f& other, int y, double step, std::vector<char>& pointed) {
  const float* d = other[y];
  pointed.assign(static_cast<std::size_t>(other.cols), 0);
  for (int q = 0; q < other.cols; ++q) {
    if (std::isnan(d[q])) continue;
    const int here = target(q, d[q]);
    int first = here, last = here;
    if (q > 0 && std::abs(static_cast<double>(d[q]) - static_cast<double>(d[q - 1])) <= step) {
      const int before = target(q - 1, d[q - 1]);
      first = std::min(before, here);
      last = std::max(before, here);
    }
    last = std::min(last, other.cols - 1);
    for (int x = std::max(first, 0); x <= last; ++x) pointed[static_cast<std::size_t>(x)] = 1;
  }
}

}  // namespace xgm::lrrl
