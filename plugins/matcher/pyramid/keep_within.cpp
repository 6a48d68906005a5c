// SPDX-License-Identifier: Apache-2.0
// Intersection of two ranges, pixel by pixel.
#include "plugins/matcher/pyramid/keep_within.hpp"

#include "xgm/base/parallel.hpp"

namespace xgm::pyramid {

DisparityRange keep_within(const DisparityRange& limits, const DisparityRange& proposed) {
  const cv::Size size = limits.size();
  cv::Mat1i begin(size), end(size);
  parallel_for(0, size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      const Interval allowed = limits.at(y, x);
      const Interval wanted = proposed.at(y, x);
      Interval kept = intersect(wanted, allowed);
      if (kept.empty() && !wanted.empty() && !allowed.empty()) kept = allowed;
      begin(y, x) = kept.begin;
      end(y, x) = kept.end;
    }
  });
  return {begin, end};
}

}  // namespace xgm::pyramid
