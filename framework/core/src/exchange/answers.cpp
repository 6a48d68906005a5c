// SPDX-License-Identifier: Apache-2.0
#include "xgm/exchange/answers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exchange/candidates.hpp"
#include "xgm/base/error.hpp"

namespace xgm::exchange {
namespace {

/// The candidates of a pixel that lie in the match image.
Interval candidates(const MatchRequest& request, int y, int x) {
  if (!request.pair.base.is_valid(y, x)) return {};
  return intersect(request.range.at(y, x), {x - request.pair.size().width + 1, x + 1});
}

/// A map of which answer(y, x) is asked for each pixel that has data.
template <class Answer>
DisparityMap map_of(const MatchRequest& request, const Answer& answer) {
  DisparityMap map(request.pair.size(), Status::out_of_range);
  parallel_for(0, map.size().height, [&](int y) {
    for (int x = 0; x < map.size().width; ++x) {
      if (!request.pair.base.is_valid(y, x)) {
        map.invalidate(y, x, Status::masked);
      } else if (const float d = answer(y, x); std::isfinite(d)) {
        map.set(y, x, d);
      }
    }
  });
  return map;
}

}  // namespace

bool can_match(const MatchRequest& request) {
  const cv::Size size = request.pair.size();
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (!candidates(request, y, x).empty()) return true;
    }
  }
  return false;
}

DisparityMap to_matched(const cv::Mat1f& disparities, const MatchRequest& request,
                        const std::string& name) {
  const bool any =
      std::any_of(disparities.begin(), disparities.end(), [](float d) { return std::isfinite(d); });
  if (!any && can_match(request)) {
    throw Error(name + ": holds no finite disparity");
  }
  return map_of(request, [&](int y, int x) {
    const Interval range = request.range.at(y, x);
    const float d = disparities(y, x);
    const bool inside = !range.empty() && d > static_cast<float>(range.begin) - 1 &&
                        d < static_cast<float>(range.end);  // as refinement may move it
    return inside ? d : std::numeric_limits<float>::quiet_NaN();
  });
}

DisparityMap rehearsed_map(const MatchRequest& request) {
  return map_of(request, [&](int y, int x) {
    const Interval seen = candidates(request, y, x);
    return seen.empty() ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(seen.begin);
  });
}

CostVolume rehearsed_costs(const ImagePair& pair, const VolumeShapePtr& shape, int max_cost) {
  CostVolume costs(shape, max_cost);
  for_each_candidate(pair, costs, [](int, int, int) { return std::uint8_t{0}; });
  return costs;
}

}  // namespace xgm::exchange
