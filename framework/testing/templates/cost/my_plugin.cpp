// SPDX-License-Identifier: Apache-2.0
// Cost "my_plugin": absolute difference of grey levels.
#include <algorithm>
#include <cmath>
#include <xgm/plugin.hpp>

namespace {

class MyPlugin final : public xgm::Cost {
 public:
  struct Parameters {
    double limit = 60;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("limit", p.limit, "Greater differences cost no more than this.").range(1, 254);
  }
  explicit MyPlugin(Parameters p) : limit_(p.limit) {}

  xgm::CostVolume run(const xgm::ImagePair& pair, const xgm::VolumeShapePtr& shape,
                      const xgm::Context&) const override {
    const cv::Mat1f base = pair.base.grey(), match = pair.match.grey();
    xgm::CostVolume costs(shape, static_cast<int>(limit_));
    xgm::parallel_for(0, shape->height(), [&](int y) {
      for (int x = 0; x < shape->width(); ++x) {
        std::uint8_t* cell = costs.at(y, x);
        for (int d = shape->begin(y, x); d < shape->end(y, x); ++d, ++cell) {
          const bool visible = x - d >= 0 && x - d < match.cols && pair.match.is_valid(y, x - d);
          *cell = visible ? cost(base(y, x), match(y, x - d)) : costs.kNoMatch;
        }
      }
    });
    return costs;
  }

 private:
  std::uint8_t cost(float base, float match) const {
    return static_cast<std::uint8_t>(std::min<double>(std::abs(base - match), limit_));
  }

  double limit_;
};

}  // namespace

XGM_PLUGIN(registry) { registry.add<MyPlugin>("my_plugin", "Absolute difference of grey levels."); }
