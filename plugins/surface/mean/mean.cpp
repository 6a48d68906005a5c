// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include "xgm/geo/stage/reduce_cells.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class Mean final : public Surface {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit Mean(Parameters) {}

  Raster run(const GridPoints& points, const GridSpec& grid, const Context&) const override {
    return reduce_cells(points, grid, [](std::span<double> heights) {
      return std::accumulate(heights.begin(), heights.end(), 0.0) /
             static_cast<double>(heights.size());
    });
  }
};

}  // namespace

XGM_PLUGIN(registry) { registry.add<Mean>("mean", "The mean height of the points in each cell."); }
