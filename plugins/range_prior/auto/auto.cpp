// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/stage/range_prior.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class Auto final : public RangePrior {
 public:
  struct Parameters {
    Slot<RangePrior> with_dem;
    Slot<RangePrior> without_dem;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("with_dem", p.with_dem, "Used if there is a DEM.").default_stage("dem_sculpting");
    set.add("without_dem", p.without_dem, "Used if there is none.").default_stage("keypoints");
  }

  explicit Auto(Parameters parameters) : p_(std::move(parameters)) {}

  bool needs_dem() const override { return p_.without_dem->needs_dem(); }

  HeightInterval heights(const SatelliteImage& base, const SatelliteImage& match,
                         const cv::Rect& window, const HeightField* dem,
                         const Context& context) const override {
    return chosen(dem)->heights(base, match, window, dem, context);
  }

  DisparityRange run(const RectifiedPair& pair, const HeightField* const& dem,
                     const Context& context) const override {
    return chosen(dem)(context, pair, dem);
  }

 private:
  const Slot<RangePrior>& chosen(const HeightField* dem) const {
    return dem != nullptr ? p_.with_dem : p_.without_dem;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Auto>("auto", "Bounded by a DEM if there is one, else by key points.");
}
