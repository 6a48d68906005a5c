// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "xgm/geo/stage/reduce_cells.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class HighestWithinCell final : public Surface {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit HighestWithinCell(Parameters) {}

  Raster run(const GridPoints& points, const GridSpec& grid, const Context&) const override {
    return reduce_cells(points, grid, [](std::span<double> heights) {
      return *std::max_element(heights.begin(), heights.end());
    });
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<HighestWithinCell>(
      "highest_within_cell", "The highest point in each cell: roofs in place of the walls below.");
}
