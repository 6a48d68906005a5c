// SPDX-License-Identifier: Apache-2.0
// Penalty "constant": P1 and P2 of the paper's Eq. 2, the same everywhere.
#include "plugins/penalty/step_penalties/describe.hpp"
#include "xgm/plugin.hpp"

namespace {

class ConstantField final : public xgm::PenaltyField {
 public:
  explicit ConstantField(xgm::PenaltyPair pair) { table_.entries = {pair}; }
  xgm::PenaltyTable table(xgm::Direction) const override { return table_; }

 private:
  xgm::PenaltyTable table_;
};

class Constant final : public xgm::Penalty {
 public:
  using Parameters = xgm::penalty::Weights;

  static void describe(Parameters& p, xgm::ParameterSet& set) { xgm::penalty::describe(p, set); }

  explicit Constant(const Parameters& p) : pair_{p.p1, p.p2} {}

  std::unique_ptr<const xgm::PenaltyField> run(const xgm::ImagePair&,
                                               const xgm::Context&) const override {
    return std::make_unique<ConstantField>(pair_);
  }

 private:
  xgm::PenaltyPair pair_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Constant>("constant", "The same P1 and P2 everywhere.",
                         "Hirschmueller, Stereo processing by semiglobal matching and mutual "
                         "information, PAMI 2008");
}
