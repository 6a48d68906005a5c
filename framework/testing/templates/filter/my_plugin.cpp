// SPDX-License-Identifier: Apache-2.0
// Filter "my_plugin": takes the disparities of far points away.
#include <cmath>
#include <xgm/plugin.hpp>

namespace {

class MyPlugin final : public xgm::Filter {
 public:
  struct Parameters {
    double least = 4;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("least", p.least, "Disparities nearer to 0 are taken away.").unit("px").range(0, 10000);
  }
  explicit MyPlugin(Parameters p) : least_(p.least) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    xgm::DisparityMap result = map.clone();  // inputs are never changed
    xgm::parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) {
        const bool far = map.has_disparity(y, x) && std::abs(map.disparity(y, x)) < least_;
        if (far) result.invalidate(y, x, xgm::Status::out_of_range);
      }
    });
    return result;
  }

 private:
  double least_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MyPlugin>("my_plugin", "Takes the disparities of far points away.");
}
