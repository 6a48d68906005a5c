// SPDX-License-Identifier: Apache-2.0
// Sub-pixel disparity from two lines of opposite slope through three sums (V-fit).
#include <algorithm>

#include "plugins/refinement/three_point/three_point.hpp"
#include "xgm/plugin.hpp"

namespace {

class Equiangular final : public xgm::Refinement {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit Equiangular(Parameters) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::AggregatedVolume& sums,
                        const xgm::Context&) const override {
    // The steeper side passes through S(d) and its neighbour; the line of opposite slope through
    // the other neighbour meets it at (below - above) / (2 slope).
    return xgm::three_point::refine(map, sums, [](xgm::three_point::Rises rises) {
      return static_cast<float>(rises.below - rises.above) /
             static_cast<float>(2 * std::max(rises.below, rises.above));
    });
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Equiangular>(
      "equiangular",
      "Moves a disparity to where two lines of opposite slope through its sum "
      "and the two beside it meet.",
      "Shimizu and Okutomi, Precise sub-pixel estimation on area-based "
      "matching, ICCV 2001");
}
