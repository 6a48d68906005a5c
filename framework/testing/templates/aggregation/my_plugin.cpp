// SPDX-License-Identifier: Apache-2.0
// Aggregation "my_plugin": each cost by itself. Add what its neighbours say to it.
#include <xgm/plugin.hpp>

namespace {

class MyPlugin final : public xgm::Aggregation {
 public:
  struct Parameters {
    int weight = 1;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("weight", p.weight, "Factor of the cost itself.").range(1, 16);
  }
  explicit MyPlugin(Parameters p) : weight_(p.weight) {}

  xgm::AggregatedVolume run(const xgm::CostVolume& costs, const xgm::PenaltyField&,
                            const xgm::Context&) const override {
    xgm::AggregatedVolume sums(costs.shape_ptr(), 0);
    const xgm::VolumeShape& shape = costs.shape();
    xgm::parallel_for(0, shape.height(), [&](int y) {
      for (int x = 0; x < shape.width(); ++x) {
        std::uint16_t* sum = sums.at(y, x);
        for (const std::uint8_t cost : costs.cells(y, x)) {
          // What cannot match stays so.
          *sum++ =
              cost == costs.kNoMatch ? sums.kNoMatch : static_cast<std::uint16_t>(weight_ * cost);
        }
      }
    });
    return sums;
  }

 private:
  int weight_;
};

}  // namespace

XGM_PLUGIN(registry) { registry.add<MyPlugin>("my_plugin", "Each cost by itself."); }
