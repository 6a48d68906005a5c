// SPDX-License-Identifier: Apache-2.0
// Refinement "my_plugin": the vertex of the parabola through the sums beside the winner.
#include <algorithm>
#include <xgm/plugin.hpp>

namespace {

/// -0.5 to 0.5: where the parabola through (-1, left), (0, centre), (1, right) is lowest.
float vertex(int left, int centre, int right) {
  const int curvature = left - 2 * centre + right;
  if (curvature <= 0) return 0;
  const float shift = 0.5F * static_cast<float>(left - right) / static_cast<float>(curvature);
  return std::clamp(shift, -0.5F, 0.5F);
}

class MyPlugin final : public xgm::Refinement {
 public:
  struct Parameters {
    double strength = 1;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("strength", p.strength, "Share of the way to the vertex.").range(0, 1);
  }
  explicit MyPlugin(Parameters p) : strength_(static_cast<float>(p.strength)) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::AggregatedVolume& sums,
                        const xgm::Context&) const override {
    xgm::DisparityMap result = map.clone();
    const xgm::VolumeShape& shape = sums.shape();
    xgm::parallel_for(0, shape.height(), [&](int y) {
      for (int x = 0; x < shape.width(); ++x) {
        if (!map.has_disparity(y, x)) continue;
        const std::uint16_t* cells = sums.at(y, x);
        const int i = static_cast<int>(map.disparity(y, x)) - shape.begin(y, x);
        if (i < 1 || i + 1 >= shape.count(y, x)) continue;  // no neighbour on one side
        if (cells[i - 1] == sums.kNoMatch || cells[i + 1] == sums.kNoMatch) continue;
        result.disparity(y, x) += strength_ * vertex(cells[i - 1], cells[i], cells[i + 1]);
      }
    });
    return result;
  }

 private:
  float strength_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MyPlugin>("my_plugin", "The vertex of a parabola through three sums.");
}
