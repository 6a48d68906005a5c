// SPDX-License-Identifier: Apache-2.0
// Half-pixel extremes of a row; linear interpolation has them at the ends or at the pixel itself.
#include "plugins/cost/birchfield_tomasi/intensity_range.hpp"

#include <algorithm>

namespace xgm::birchfield_tomasi {

IntensityRow intensity_row(const Image& image, std::size_t channel, int y) {
  const cv::Mat1f& plane = image.planes[channel];
  const auto halfway = [&](int x, int neighbour) {
    const bool exists = neighbour >= 0 && neighbour < plane.cols && image.is_valid(y, neighbour);
    return exists ? (plane(y, x) + plane(y, neighbour)) / 2 : plane(y, x);
  };
  IntensityRow row;
  for (int x = 0; x < plane.cols; ++x) {
    const auto [low, high] = std::minmax({halfway(x, x - 1), plane(y, x), halfway(x, x + 1)});
    row.value.push_back(plane(y, x));
    row.low.push_back(low);
    row.high.push_back(high);
  }
  return row;
}

IntensityRow mirrored(IntensityRow row) {
  std::reverse(row.value.begin(), row.value.end());
  std::reverse(row.low.begin(), row.low.end());
  std::reverse(row.high.begin(), row.high.end());
  return row;
}

}  // namespace xgm::birchfield_tomasi
