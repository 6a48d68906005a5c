// SPDX-License-Identifier: Apache-2.0
// By what is known: a DEM, else key points, and beyond them a coarser run where that pays.
#include <algorithm>

#include "xgm/geo/stage/range_prior.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class Auto final : public RangePrior {
 public:
  struct Parameters {
    Slot<RangePrior> with_dem;
    Slot<RangePrior> without_dem;
    Slot<RangePrior> large;
    int large_side = 4000;
    double wide_search = 200;
  };

  static void describe(Parameters& p, ParameterSet& set) {
    set.add("with_dem", p.with_dem, "Used if there is a DEM.").default_stage("dem_sculpting");
    set.add("without_dem", p.without_dem, "Used if there is none.").default_stage("keypoints");
    set.add("large", p.large,
            "Used in its place where images are large and it leaves a wide search.")
        .default_stage("coarse_surface");
    set.add("large_side", p.large_side, "An image is large if one of its sides is not shorter.")
        .unit("px")
        .range(1, 1000000);
    set.add("wide_search", p.wide_search,
            "A search is wide if it has so many disparities, or more.")
        .unit("px")
        .range(1, 100000);
  }

  explicit Auto(Parameters parameters) : p_(std::move(parameters)) {}

  bool needs_dem() const override { return p_.without_dem->needs_dem(); }

  HeightInterval heights(const SatelliteImage& base, const SatelliteImage& match,
                         const cv::Rect& window, const HeightField* dem,
                         const Context& context) const override {
    return (dem != nullptr ? p_.with_dem : p_.without_dem)
        ->heights(base, match, window, dem, context);
  }

  const Slot<RangePrior>* coarse_prior(const SatelliteImage& base, const SatelliteImage& match,
                                       const HeightInterval& heights,
                                       const HeightField* dem) const override {
    return chosen(base, match, heights, dem)->coarse_prior(base, match, heights, dem);
  }

  DisparityRange run(const RectifiedPair& pair, const KnownSurfaces& known,
                     const Context& context) const override {
    return chosen(pair.base, pair.match, pair.heights, known.dem)(context, pair, known);
  }

 private:
  const Slot<RangePrior>& chosen(const SatelliteImage& base, const SatelliteImage& match,
                                 const HeightInterval& heights, const HeightField* dem) const {
    if (dem != nullptr) return p_.with_dem;
    const bool is_large = std::max(base.size.width, base.size.height) >= p_.large_side;
    const bool is_wide = is_large && parallax(base, match, heights) >= p_.wide_search;
    return is_wide ? p_.large : p_.without_dem;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Auto>(
      "auto",
      "Sculpted with a DEM; without one by key points, and by a coarser run in large "
      "images where these leave much.");
}
