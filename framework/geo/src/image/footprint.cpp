// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/image/footprint.hpp"

#include <algorithm>

namespace xgm::geo {

std::optional<DegreeBox> footprint(const SatelliteImage& image, const cv::Rect& window,
                                   const HeightInterval& heights) {
  constexpr int kSteps = 4;  // per direction
  std::optional<DegreeBox> box;
  for (int k = 0; k < 2 * (kSteps + 1) * (kSteps + 1); ++k) {
    const int column = k / 2 % (kSteps + 1), row = k / 2 / (kSteps + 1);
    const cv::Point2d pixel(window.x + (window.width - 1.0) * column / kSteps,
                            window.y + (window.height - 1.0) * row / kSteps);
    const auto point = image.camera.localize(pixel, k % 2 == 0 ? heights.min : heights.max);
    if (!point) continue;
    const double x = point->longitude, y = point->latitude;
    if (!box) box = DegreeBox(x, y, x, y);
    box = DegreeBox(std::min((*box)[0], x), std::min((*box)[1], y), std::max((*box)[2], x),
                    std::max((*box)[3], y));
  }
  return box;
}

}  // namespace xgm::geo
