// SPDX-License-Identifier: Apache-2.0
// Consistency "my_plugin": a disparity stays if the pixel it points at points back.
#include <cmath>
#include <xgm/plugin.hpp>

namespace {

class MyPlugin final : public xgm::Consistency {
 public:
  struct Parameters {
    double threshold = 1;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("threshold", p.threshold, "Largest difference of both disparities.")
        .unit("px")
        .range(0, 1000);
  }
  explicit MyPlugin(Parameters p) : threshold_(p.threshold) {}

  xgm::MatchResult run(const xgm::MatchResult& maps, const xgm::Context&) const override {
    if (!maps.reverse) throw xgm::Error("there is no map of the other view to compare with");
    return {checked(maps.forward, *maps.reverse), checked(*maps.reverse, maps.forward)};
  }

 private:
  xgm::DisparityMap checked(const xgm::DisparityMap& map, const xgm::DisparityMap& other) const {
    xgm::DisparityMap result = map.clone();
    xgm::parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) {
        if (map.has_disparity(y, x) && !agrees(map, other, y, x))
          result.invalidate(y, x, xgm::Status::mismatched);
      }
    });
    return result;
  }

  /// Disparities of both views have opposite signs.
  bool agrees(const xgm::DisparityMap& map, const xgm::DisparityMap& other, int y, int x) const {
    const float d = map.disparity(y, x);
    const int target = x - static_cast<int>(std::lround(d));
    return target >= 0 && target < other.size().width && other.has_disparity(y, target) &&
           std::abs(d + other.disparity(y, target)) <= threshold_;
  }

  double threshold_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MyPlugin>("my_plugin", "Keeps disparities on which both views agree.");
}
