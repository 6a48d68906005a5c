// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/stage/reduce_cells.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class Median final : public Surface {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit Median(Parameters) {}

  Raster run(const GridPoints& points, const GridSpec& grid, const Context&) const override {
    return reduce_cells(points, grid, geo::median);
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Median>("median", "The median height of the points in each cell.");
}
