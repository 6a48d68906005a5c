// SPDX-License-Identifier: Apache-2.0
// From proposals of coarse pixels to the range of the finer level.
#include "plugins/search_range/window_statistics/proposal.hpp"

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
  return DisparityRange::of_pixels(limits.size(), [&](int y, int x) {
    return cut(proposal.at(y / 2, x / 2), limits.at(y, x), relaxation);
  });
}

}  // namespace xgm::search_range
