// SPDX-License-Identifier: Apache-2.0
// Cost "squared_difference": (I_b(x, y) - I_m(x - d, y))^2 / scale of grey images, truncated.
#include <algorithm>
#include <xgm/plugin.hpp>

namespace {

class SquaredDifference final : public xgm::Cost {
 public:
  struct Parameters {
    double scale = 8;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("scale", p.scale, "Squared grey levels per unit of cost.").range(0.01, 1000);
  }
  explicit SquaredDifference(Parameters p) : scale_(static_cast<float>(p.scale)) {}

  xgm::CostVolume run(const xgm::ImagePair& pair, const xgm::VolumeShapePtr& shape,
                      const xgm::Context&) const override {
    const cv::Mat1f base = pair.base.grey(), match = pair.match.grey();
    xgm::CostVolume costs(shape, kMaxCost);
    xgm::parallel_for(0, shape->height(), [&](int y) {
      for (int x = 0; x < shape->width(); ++x) {
        std::uint8_t* cell = costs.at(y, x);
        for (int d = shape->begin(y, x); d < shape->end(y, x); ++d, ++cell) {
          const bool visible = x - d >= 0 && x - d < base.cols && pair.match.is_valid(y, x - d);
          *cell = visible ? cost(base(y, x) - match(y, x - d)) : costs.kNoMatch;
        }
      }
    });
    return costs;
  }

 private:
  static constexpr int kMaxCost = 100;
  std::uint8_t cost(float difference) const {
    return static_cast<std::uint8_t>(std::min(kMaxCost * 1.0F, difference * difference / scale_));
  }
  float scale_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<SquaredDifference>("squared_difference", "Squared difference of grey levels.");
}
