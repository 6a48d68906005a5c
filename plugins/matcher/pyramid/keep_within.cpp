// SPDX-License-Identifier: Apache-2.0
// Intersection of two ranges, pixel by pixel.
#include "plugins/matcher/pyramid/keep_within.hpp"

namespace xgm::pyramid {

DisparityRange keep_within(const DisparityRange& limits, const DisparityRange& proposed) {
  return DisparityRange::of_pixels(limits.size(), [&](int y, int x) {
    const Interval allowed = limits.at(y, x), wanted = proposed.at(y, x);
    const Interval both = intersect(wanted, allowed);
    return both.empty() && !wanted.empty() && !allowed.empty() ? allowed : both;
  });
}

}  // namespace xgm::pyramid
