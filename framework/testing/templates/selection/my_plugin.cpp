// SPDX-License-Identifier: Apache-2.0
// Selection "my_plugin": the disparity with the smallest sum.
#include <algorithm>
#include <xgm/plugin.hpp>

namespace {

class MyPlugin final : public xgm::Selection {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit MyPlugin(Parameters) {}

  xgm::DisparityMap run(const xgm::AggregatedVolume& sums, const xgm::Context&) const override {
    const xgm::VolumeShape& shape = sums.shape();
    xgm::DisparityMap map(shape.size());  // out_of_range everywhere
    xgm::parallel_for(0, shape.height(), [&](int y) {
      for (int x = 0; x < shape.width(); ++x) {
        const auto cells = sums.cells(y, x);
        const auto least = std::min_element(cells.begin(), cells.end());
        if (least == cells.end() || *least == sums.kNoMatch) continue;
        map.set(y, x, static_cast<float>(shape.begin(y, x) + (least - cells.begin())));
      }
    });
    return map;
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MyPlugin>("my_plugin", "The disparity with the smallest sum.");
}
