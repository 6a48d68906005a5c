// SPDX-License-Identifier: Apache-2.0
// Cuts a range to the width of the match image.
#include "plugins/matcher/semi_global/matchable.hpp"

namespace xgm::semi_global {

DisparityRange matchable(const DisparityRange& range) {
  const cv::Size size = range.size();
  return DisparityRange::of_pixels(size, [&](int y, int x) {
    return intersect(range.at(y, x), {x - size.width + 1, x + 1});
  });
}

}  // namespace xgm::semi_global
