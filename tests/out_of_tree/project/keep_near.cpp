// SPDX-License-Identifier: Apache-2.0
// Filter "keep_near": takes away what is farther than wanted (the plugin of README.md).
#include <xgm/plugin.hpp>

class KeepNear final : public xgm::Filter {
 public:
  struct Parameters {
    double farthest = 8;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("farthest", p.farthest, "Smallest disparity to keep.").unit("px").range(0, 10000);
  }
  explicit KeepNear(Parameters p) : p_(p) {}

  xgm::DisparityMap run(const xgm::DisparityMap& map, const xgm::ImagePair&,
                        const xgm::Context&) const override {
    xgm::DisparityMap result = map.clone();
    xgm::parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) {
        const bool far = map.has_disparity(y, x) && map.disparity(y, x) < p_.farthest;
        if (far) result.invalidate(y, x, xgm::Status::out_of_range);
      }
    });
    return result;
  }

 private:
  Parameters p_;
};

XGM_PLUGIN(registry) {
  registry.add<KeepNear>("keep_near", "Takes away disparities below a limit.");
}
