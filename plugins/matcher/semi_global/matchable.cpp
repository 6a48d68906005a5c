// SPDX-License-Identifier: Apache-2.0
// Cuts a range to the width of the match image.
#include "plugins/matcher/semi_global/matchable.hpp"

#include "xgm/base/parallel.hpp"

namespace xgm::semi_global {

DisparityRange matchable(const DisparityRange& range) {
  const cv::Size size = range.size();
  cv::Mat1i begin(size), end(size);
  parallel_for(0, size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      const Interval inside = intersect(range.at(y, x), {x - size.width + 1, x + 1});
      begin(y, x) = inside.begin;
      end(y, x) = inside.end;
    }
  });
  return {begin, end};
}

}  // namespace xgm::semi_global
