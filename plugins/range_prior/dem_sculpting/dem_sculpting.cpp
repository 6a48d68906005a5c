// SPDX-License-Identifier: Apache-2.0
// The paper's DEM-sculpting, with its offsets and a margin.
#include "plugins/range_prior/sculpting/sculpting.hpp"

namespace {

using namespace xgm;
using namespace xgm::geo;

class DemSculpting final : public RangePrior {
 public:
  using Parameters = SculptingParameters;

  static void describe(Parameters& p, ParameterSet& set) { describe_sculpting(p, set, "the DEM"); }

  explicit DemSculpting(Parameters parameters) : p_(parameters) {}

  bool needs_dem() const override { return true; }

  HeightInterval heights(const SatelliteImage& base, const SatelliteImage&, const cv::Rect& window,
                         const HeightField* dem, const Context&) const override {
    if (dem == nullptr) throw UsageError("range_prior dem_sculpting: give a DEM (--dem FILE)");
    const HeightInterval ground = dem_heights(base, window, *dem);
    const HeightInterval moves = sculpting_offsets(p_, base.camera.heights(), dem->bounds());
    return {ground.min + moves.min, ground.max + moves.max};
  }

  DisparityRange run(const RectifiedPair& pair, const KnownSurfaces& known,
                     const Context& context) const override {
    const HeightField& dem = *known.dem;
    const HeightInterval moves = sculpting_offsets(p_, pair.base.camera.heights(), dem.bounds());
    context.figure("upper_m", moves.max);
    context.figure("lower_m", moves.min);
    return spread(filled_by_nearest(sparse_bounds(pair, dem, dem, moves, p_.step)),
                  pair.geometry->size(), p_.step);
  }

 private:
  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<DemSculpting>(
      "dem_sculpting",
      "A range per pixel: disparities between two copies of a DEM, moved up and down.",
      "Patil, Prakash, Comandur, Kak: A Comparative Evaluation of SGM Variants (including a New "
      "Variant, tMGM) for Dense Stereo Matching, section DEM-Sculpting");
}
