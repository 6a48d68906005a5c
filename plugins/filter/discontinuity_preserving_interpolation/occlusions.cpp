// SPDX-License-Identifier: Apache-2.0
#include "plugins/filter/discontinuity_preserving_interpolation/occlusions.hpp"

#include <vector>

namespace xgm::discontinuity_preserving_interpolation {

cv::Mat1b occlusions(const DisparityMap& map, bool spread) {
  const cv::Rect image({}, map.size());
  cv::Mat1b occluded;
  cv::compare(map.status, static_cast<int>(Status::occluded), occluded, cv::CMP_EQ);
  if (!spread) return occluded;
  std::vector<cv::Point> front;
  cv::findNonZero(occluded, front);
  while (!front.empty()) {
    const cv::Point p = front.back();
    front.pop_back();
    for (const cv::Point step : {cv::Point(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      const cv::Point q = p + step;
      if (!image.contains(q) || occluded(q) != 0) continue;
      if (map.at(q.y, q.x) != Status::mismatched) continue;
      occluded(q) = 255;
      front.push_back(q);
    }
  }
  return occluded;
}

}  // namespace xgm::discontinuity_preserving_interpolation
