// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "plugins/surface/cells/cells.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class Median final : public Surface {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit Median(Parameters) {}

  Raster run(const GridPoints& points, const GridSpec& grid, const Context&) const override {
    return reduce_cells(points, grid, [](std::span<double> heights) {
      const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
      std::nth_element(heights.begin(), middle, heights.end());
      if (heights.size() % 2 != 0) return *middle;
      return (*middle + *std::max_element(heights.begin(), middle)) / 2;
    });
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Median>("median", "The median height of the points in each cell.");
}
