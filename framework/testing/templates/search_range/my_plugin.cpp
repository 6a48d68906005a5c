// SPDX-License-Identifier: Apache-2.0
// Search range "my_plugin": twice the disparity of the coarser level, and some more to both sides.
#include <cmath>
#include <xgm/plugin.hpp>

namespace {

class MyPlugin final : public xgm::SearchRange {
 public:
  struct Parameters {
    int margin = 8;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("margin", p.margin, "Searched to both sides, in pixels of the finer level.")
        .unit("px")
        .range(1, 1000);
  }
  explicit MyPlugin(Parameters p) : margin_(p.margin) {}

  xgm::DisparityRange run(const xgm::DisparityMap& coarse, const xgm::DisparityRange& limits,
                          const xgm::Context&) const override {
    return xgm::DisparityRange::of_pixels(limits.size(), [&](int y, int x) {
      const xgm::Interval all = limits.at(y, x);
      if (!coarse.has_disparity(y / 2, x / 2)) return all;
      const int d = static_cast<int>(std::lround(2 * coarse.disparity(y / 2, x / 2)));
      const xgm::Interval near = intersect({d - margin_, d + margin_ + 1}, all);
      return near.empty() ? all : near;  // some disparity is left wherever there was one
    });
  }

 private:
  int margin_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MyPlugin>("my_plugin", "Searches around the disparity of the coarser level.");
}
