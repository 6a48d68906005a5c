// SPDX-License-Identifier: Apache-2.0
// From proposals of coarse pixels to the range of the finer level.
#include "plugins/search_range/shared/proposal.hpp"

#include "xgm/base/parallel.hpp"

namespace xgm::search_range {
namespace {

Interval cut(Interval proposed, Interval limits, int relaxation) {
  if (limits.empty()) return {};
  const Interval all{limits.begin - relaxation, limits.end + relaxation};
  const Interval both = intersect(proposed, all);
  return both.empty() ? all : both;
}

}  // namespace

Interval relaxed(double low, double high, int relaxation) {
  return {fine_floor(low) - relaxation, fine_ceil(high) + relaxation + 1};
}

DisparityRange cut(const Proposal& proposal, const DisparityRange& limits, int relaxation) {
  const cv::Size size = limits.size();
  cv::Mat1i begin(size), end(size);
  parallel_for(0, size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      const Interval searched = cut(proposal.at(y / 2, x / 2), limits.at(y, x), relaxation);
      begin(y, x) = searched.begin;
      end(y, x) = searched.end;
    }
  });
  return {begin, end};
}

}  // namespace xgm::search_range
