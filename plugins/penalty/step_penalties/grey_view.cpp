// SPDX-License-Identifier: Apache-2.0
// Differences along a path, without a branch per pixel.
#include "plugins/penalty/step_penalties/grey_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace xgm::penalty {

GreyView::GreyView(const Image& image) : grey_(image.grey()) {
  if (image.valid.empty()) return;
  grey_ = grey_.clone();
  grey_.setTo(std::numeric_limits<float>::quiet_NaN(), image.valid == 0);
}

void GreyView::differences(Direction r, int y, std::span<float> out) const {
  std::fill(out.begin(), out.end(), 0.0F);
  const int y_before = y - r.dy;
  if (y_before < 0 || y_before >= grey_.rows) return;
  const float* const own = grey_[y];
  const float* const before = grey_[y_before] - r.dx;
  float* const differences = out.data();
  const int end = std::min(grey_.cols, grey_.cols + r.dx);
  for (int x = std::max(0, r.dx); x < end; ++x) {
    const float difference = std::abs(own[x] - before[x]);
    differences[x] = difference > 0 ? difference : 0;  // also where one is masked
  }
}

}  // namespace xgm::penalty
