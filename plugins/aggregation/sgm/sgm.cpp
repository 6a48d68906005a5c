// SPDX-License-Identifier: Apache-2.0
// Semi-global matching: costs aggregated along straight paths (the paper's Eq. 3 and 4).
#include "plugins/aggregation/path_engine/aggregate.hpp"
#include "plugins/aggregation/path_engine/needs.hpp"
#include "plugins/aggregation/path_engine/parameters.hpp"
#include "plugins/aggregation/sgm/passes.hpp"
#include "xgm/plugin.hpp"

namespace {

/// L_r(p, d) = C(p, d) + min(L_r(p-r, d), L_r(p-r, d+-1) + P1, min_i L_r(p-r, i) + P2), less
/// min_i L_r(p-r, i); S is the sum over the directions r. Exact.
class Sgm final : public xgm::Aggregation, public xgm::StatesNeeds {
 public:
  using Parameters = xgm::aggregation::PathParameters;

  static void describe(Parameters& parameters, xgm::ParameterSet& set) {
    xgm::aggregation::describe(parameters, set);
  }

  explicit Sgm(const Parameters& parameters) : parameters_(parameters) {}

  xgm::AggregatedVolume run(const xgm::CostVolume& costs, const xgm::PenaltyField& penalties,
                            const xgm::Context& context) const override {
    return xgm::aggregation::aggregate_paths(
        costs, penalties, xgm::sgm::passes(parameters_.directions),
        {.overcounting_correction = parameters_.overcounting_correction}, context);
  }

  xgm::Needs needs(const xgm::Workload& load) const override {
    return xgm::aggregation::needs(load, xgm::sgm::passes(parameters_.directions));
  }

 private:
  Parameters parameters_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Sgm>("sgm", "Semi-global matching: sums costs along 4, 8 or 16 straight paths.",
                    "H. Hirschmueller, Stereo Processing by Semiglobal Matching and Mutual "
                    "Information, IEEE TPAMI 30(2), 2008; overcounting correction: A. Drory et "
                    "al., Semi-Global Matching: A Principled Derivation in Terms of Message "
                    "Passing, GCPR 2014");
}
