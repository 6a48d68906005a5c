// SPDX-License-Identifier: Apache-2.0
// Differences along a path, without a branch per pixel for the image border.
#include "plugins/penalty/shared/grey_view.hpp"

#include <algorithm>
#include <cmath>

namespace xgm::penalty {

void GreyView::differences(Direction r, int y, std::span<float> out) const {
  std::fill(out.begin(), out.end(), 0.0F);
  const int before = y - r.dy;
  if (before < 0 || before >= grey_.rows) return;
  const int begin = std::max(0, r.dx);
  const int end = std::min(grey_.cols, grey_.cols + r.dx);
  for (int x = begin; x < end; ++x) {
    if (!is_valid(y, x) || !is_valid(before, x - r.dx)) continue;
    out[static_cast<std::size_t>(x)] = std::abs(grey_(y, x) - grey_(before, x - r.dx));
  }
}

}  // namespace xgm::penalty
