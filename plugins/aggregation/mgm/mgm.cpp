// SPDX-License-Identifier: Apache-2.0
// More global matching: each path also takes the message of a perpendicular neighbour (the paper's
// Eq. 6).
#include "plugins/aggregation/mgm/passes.hpp"
#include "plugins/aggregation/path_engine/aggregate.hpp"
#include "plugins/aggregation/path_engine/needs.hpp"
#include "plugins/aggregation/path_engine/parameters.hpp"
#include "xgm/plugin.hpp"

namespace {

/// L_r(p, d) = C(p, d) + 1/2 sum over x in {r, r-perp} of
///   [ min(L_r(p-x, d), L_r(p-x, d+-1) + P1(x), min_i L_r(p-x, i) + P2(x)) - min_i L_r(p-x, i) ],
/// r-perp being r turned anticlockwise as seen on the screen; S is the sum over the directions r.
///
/// Eq. 6 has L_x on the right-hand side. Read literally, this is circular: L_r would need the path
/// cost of r-perp, which would need that of -r, and after four steps L_r(p, d) itself. The
/// recursion of Facciolo et al., which the paper describes, has L_r in both terms, and so has this
/// one.
///
/// If only one of p - r and p - r-perp exists (border, no data), its message counts fully. P1 and
/// P2 are those of step x. Sums are fixed-point numbers (AggregatedVolume::fraction_bits);
/// path_engine/fixed_point.hpp derives their error.
class Mgm final : public xgm::Aggregation, public xgm::StatesNeeds {
 public:
  using Parameters = xgm::aggregation::PathParameters;

  static void describe(Parameters& parameters, xgm::ParameterSet& set) {
    xgm::aggregation::describe(parameters, set);
  }

  explicit Mgm(const Parameters& parameters) : parameters_(parameters) {}

  xgm::AggregatedVolume run(const xgm::CostVolume& costs, const xgm::PenaltyField& penalties,
                            const xgm::Context& context) const override {
    return xgm::aggregation::aggregate_paths(
        costs, penalties, xgm::mgm::passes(parameters_.directions),
        {.overcounting_correction = parameters_.overcounting_correction}, context);
  }

  xgm::Needs needs(const xgm::Workload& load) const override {
    return xgm::aggregation::needs(load, xgm::mgm::passes(parameters_.directions));
  }

 private:
  Parameters parameters_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Mgm>("mgm",
                    "More global matching: 4, 8 or 16 paths, each averaged with the term of its "
                    "perpendicular neighbour.",
                    "G. Facciolo, C. de Franchis, E. Meinhardt, MGM: A Significantly More Global "
                    "Matching for Stereovision, BMVC 2015; overcounting correction: A. Drory et "
                    "al., Semi-Global Matching: A Principled Derivation in Terms of Message "
                    "Passing, GCPR 2014");
}
