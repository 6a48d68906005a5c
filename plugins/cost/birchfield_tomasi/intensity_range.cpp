// SPDX-License-Identifier: Apache-2.0
// Half-pixel extremes of a row; linear interpolation has them at the ends or at the pixel itself.
#include "plugins/cost/birchfield_tomasi/intensity_range.hpp"

#include <algorithm>
#include <tuple>

namespace xgm::birchfield_tomasi {

cost::PixelRow<float> intensity_rows(const Image& image, int y, const cost::RowLayout& layout) {
  const int width = image.size().width;
  const auto channels = static_cast<int>(image.planes.size());
  cost::PixelRow<float> row(image, y, channels * kIntensities, layout);
  for (int c = 0; c < channels; ++c) {
    const float* const level = image.planes[static_cast<std::size_t>(c)][y];
    const auto halfway = [&](int x, int neighbour) {
      const bool exists = neighbour >= 0 && neighbour < width && image.is_valid(y, neighbour);
      return exists ? (level[x] + level[neighbour]) / 2 : level[x];
    };
    float* const value = row.plane(c * kIntensities + kValue);
    float* const low = row.plane(c * kIntensities + kLow);
    float* const high = row.plane(c * kIntensities + kHigh);
    for (int x = 0; x < width; ++x) {
      const int i = layout.mirrored ? width - 1 - x : x;
      value[i] = level[x];
      std::tie(low[i], high[i]) = std::minmax({halfway(x, x - 1), level[x], halfway(x, x + 1)});
    }
  }
  return row;
}

}  // namespace xgm::birchfield_tomasi
