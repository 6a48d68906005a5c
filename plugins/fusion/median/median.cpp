// SPDX-License-Identifier: Apache-2.0
#include "plugins/fusion/cell_fusion/fuse_cells.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class Median final : public Fusion {
 public:
  using Parameters = CellFusion;
  static void describe(Parameters& p, ParameterSet& set) { geo::describe(p, set); }
  explicit Median(Parameters parameters) : p_(parameters) {}

  FusedSurface run(const std::vector<Raster>& surfaces, const Context& context) const override {
    return fuse_cells(surfaces, p_, median, context);
  }

 private:
  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Median>("median", "The median of what the pairs say of each cell.");
}
