// SPDX-License-Identifier: Apache-2.0
// Cost "birchfield_tomasi": a difference of grey levels that does not mind where pixels are
// sampled.
#include "plugins/cost/birchfield_tomasi/dissimilarity.hpp"
#include "plugins/cost/birchfield_tomasi/intensity_range.hpp"
#include "plugins/cost/candidate_costs/truncated_mean.hpp"
#include "xgm/plugin.hpp"

namespace {

namespace kernel = xgm::birchfield_tomasi;

class BirchfieldTomasi final : public xgm::Cost {
 public:
  using Parameters = xgm::cost::Truncation;
  static void describe(Parameters& p, xgm::ParameterSet& set) { Parameters::describe(p, set); }

  explicit BirchfieldTomasi(const Parameters& p) : truncation_(p.truncation) {}

  xgm::CostVolume run(const xgm::ImagePair& images, const xgm::VolumeShapePtr& shape,
                      const xgm::Context&) const override {
    const auto compare = [&](const xgm::cost::RowPair<float>& rows, int y, xgm::CostVolume& costs) {
      kernel::compare(rows, y, static_cast<float>(truncation_), costs);
    };
    return xgm::cost::compare_rows(images, shape, truncation_, kernel::intensity_rows, compare);
  }

 private:
  int truncation_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<BirchfieldTomasi>(
      "birchfield_tomasi",
      "Sampling-insensitive absolute difference, mean over channels, truncated.",
      "Birchfield & Tomasi, A pixel dissimilarity measure that is insensitive to image sampling, "
      "PAMI 1998");
}
