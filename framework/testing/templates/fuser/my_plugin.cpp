// SPDX-License-Identifier: Apache-2.0
// Fuser "my_plugin": the disparity of the first matcher that has one.
#include <xgm/plugin.hpp>

namespace {

class MyPlugin final : public xgm::Fuser {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit MyPlugin(Parameters) {}

  xgm::DisparityMap run(const xgm::Candidates& candidates, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    xgm::DisparityMap result = candidates.maps.front().clone();  // inputs are never changed
    xgm::parallel_for(0, result.size().height, [&](int y) {
      for (int x = 0; x < result.size().width; ++x) {
        for (const xgm::DisparityMap& map : candidates.maps) {
          if (result.has_disparity(y, x)) break;
          if (map.has_disparity(y, x)) result.set(y, x, map.disparity(y, x), map.at(y, x));
        }
      }
    });
    return result;
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MyPlugin>("my_plugin", "The disparity of the first matcher that has one.");
}
