// SPDX-License-Identifier: Apache-2.0
// Sub-pixel disparity from the lowest point of a parabola through three sums (the paper's sec. 5).
#include "plugins/refinement/three_point/three_point.hpp"
#include "xgm/plugin.hpp"

namespace {

class Parabola final : public xgm::Refinement {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit Parabola(Parameters) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::AggregatedVolume& sums,
                        const xgm::Context&) const override {
    // Vertex of a t^2 + b t + c with a = (below + above) / 2, b = (above - below) / 2: -b / (2 a).
    return xgm::three_point::refine(map, sums, [](xgm::three_point::Rises rises) {
      return static_cast<float>(rises.below - rises.above) /
             static_cast<float>(2 * (rises.below + rises.above));
    });
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Parabola>(
      "parabola",
      "Moves a disparity to the lowest point of the parabola through its sum and "
      "the two beside it.",
      "Patil et al., A comparative evaluation of SGM variants for dense stereo "
      "matching, section 5");
}
