// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/stage/range_prior.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class DemGlobal final : public RangePrior {
 public:
  struct Parameters {
    double margin = 30;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("margin", p.margin, "Added below the DEM's lowest and above its highest place.")
        .unit("m")
        .range(0, 9000);
  }

  explicit DemGlobal(Parameters parameters) : margin_(parameters.margin) {}

  bool needs_dem() const override { return true; }

  HeightInterval heights(const SatelliteImage& base, const SatelliteImage&, const cv::Rect& window,
                         const HeightField* dem, const Context&) const override {
    if (dem == nullptr) throw UsageError("range_prior dem_global: give a DEM (--dem FILE)");
    const HeightInterval heights = dem_heights(base, window, *dem);
    return {heights.min - margin_, heights.max + margin_};
  }

 private:
  double margin_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<DemGlobal>("dem_global",
                          "One range for all pixels: disparities between the lowest and the "
                          "highest place of a DEM.");
}
