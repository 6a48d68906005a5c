// SPDX-License-Identifier: Apache-2.0
// Winner takes all: the disparity with the lowest sum, if asked only where it clearly wins.
#include "plugins/selection/wta/winner.hpp"
#include "xgm/plugin.hpp"

namespace {

class Wta final : public xgm::Selection {
 public:
  struct Parameters {
    int uniqueness = 0;
  };
  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("uniqueness", p.uniqueness,
            "How clearly the best disparity must win, 0 for not at all: the sums of all "
            "disparities not next to it must exceed its own by more than this share of the "
            "pixel's contrast (mean sum less lowest sum), else the pixel becomes ambiguous.")
        .unit("%")
        .range(0, 100);
  }
  explicit Wta(Parameters p) : p_(p) {}

  xgm::DisparityMap run(const xgm::AggregatedVolume& sums, const xgm::Context&) const override {
    xgm::DisparityMap map;
    map.disparity.create(sums.shape().size());  // not filled: every pixel will be set
    map.status.create(sums.shape().size());
    xgm::parallel_for(0, sums.shape().height(),
                      [&](int y) { xgm::wta::select(sums, p_.uniqueness, y, map); });
    return map;
  }

 private:
  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Wta>(
      "wta", "Takes the disparity with the lowest sum; of equal ones the smallest disparity.",
      "Hirschmueller, Stereo processing by semiglobal matching and mutual "
      "information, PAMI 2008");
}
