// SPDX-License-Identifier: Apache-2.0
// Confidence "my_plugin": the share of the neighbours whose disparity is nearly the same.
#include <cmath>
#include <limits>
#include <xgm/plugin.hpp>

namespace {

class MyPlugin final : public xgm::Confidence {
 public:
  struct Parameters {
    int window = 5;
    double difference = 1;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("window", p.window, "Side of the window.").unit("px").range(3, 51).odd();
    set.add("difference", p.difference, "Largest difference that is nearly the same.")
        .unit("px")
        .range(0, 1000);
  }
  explicit MyPlugin(Parameters p) : p_(p) {}

  cv::Mat1f run(const xgm::Evidence& evidence, const xgm::Context&) const override {
    const xgm::DisparityMap& map = evidence.map;
    cv::Mat1f confidence(map.size(), std::numeric_limits<float>::quiet_NaN());
    xgm::parallel_for(0, map.size().height, [&](int y) {
      for (int x = 0; x < map.size().width; ++x) {
        if (map.has_disparity(y, x)) confidence(y, x) = agreement(map, y, x);
      }
    });
    return confidence;
  }

 private:
  /// 0 to 1, of the pixels of the window that lie in the image.
  float agreement(const xgm::DisparityMap& map, int y, int x) const {
    const cv::Rect image({0, 0}, map.size());
    const int radius = p_.window / 2;
    int near = 0, count = 0;
    for (int v = y - radius; v <= y + radius; ++v) {
      for (int u = x - radius; u <= x + radius; ++u) {
        if (!image.contains({u, v})) continue;
        ++count;
        if (!map.has_disparity(v, u)) continue;
        if (std::abs(map.disparity(v, u) - map.disparity(y, x)) <= p_.difference) ++near;
      }
    }
    return static_cast<float>(near) / static_cast<float>(count);
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MyPlugin>("my_plugin", "The share of neighbours with nearly the same disparity.");
}
