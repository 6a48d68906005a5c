// SPDX-License-Identifier: Apache-2.0
// Penalty "two_image_gradient": P1 and P2 fall where the intensity changes along the path in one
// view, and further where it does in both (the paper, section 5).
#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/penalty/step_penalties/describe.hpp"
#include "plugins/penalty/step_penalties/grey_view.hpp"
#include "plugins/penalty/two_image_gradient/orientation.hpp"
#include "xgm/plugin.hpp"

namespace {

using xgm::two_image_gradient::Orientation;

struct Parameters {
  xgm::penalty::Weights weights;
  double tau = 20;
  double q1 = 3;
  double q2 = 6;
  double v = 1.25;
};

/// P1 and P2 divided by q, with P1 adapted to the orientation; rounded, and P1 no more than P2.
xgm::PenaltyPair adapted(const Parameters& p, double q, Orientation orientation) {
  double p1 = p.weights.p1 / q;
  if (orientation == Orientation::vertical) p1 /= p.v;
  if (orientation == Orientation::diagonal) p1 *= std::sqrt(1 + p.v * p.v) / p.v;
  const auto p2 = static_cast<int>(std::lround(p.weights.p2 / q));
  return {std::min(static_cast<int>(std::lround(p1)), p2), p2};
}

/// The largest float that is not above `bound`: floats compare with it as with `bound`, and faster.
float as_float(double bound) {
  const auto nearest = static_cast<float>(bound);
  return nearest > bound ? std::nextafter(nearest, 0.0F) : nearest;
}

/// Two classes in each view: 0 where the intensity changes by tau at most, 1 where by more. The
/// paper's cases overlap at D = tau; here it belongs to the first of them, D <= tau.
class Field final : public xgm::PenaltyField {
 public:
  Field(const xgm::ImagePair& pair, const Parameters& p)
      : base_(pair.base), match_(pair.match), parameters_(p), tau_(as_float(p.tau)) {}

  xgm::PenaltyTable table(xgm::Direction r) const override {
    const Orientation orientation = xgm::two_image_gradient::orientation(r);
    const xgm::PenaltyPair in_none = adapted(parameters_, 1, orientation);
    const xgm::PenaltyPair in_one = adapted(parameters_, parameters_.q1, orientation);
    const xgm::PenaltyPair in_both = adapted(parameters_, parameters_.q2, orientation);
    return {2, 2, {in_none, in_one, in_one, in_both}};
  }

  void classify(xgm::Direction r, int y, std::span<std::uint8_t> base,
                std::span<std::uint8_t> match) const override {
    classify(base_, r, y, base);
    classify(match_, r, y, match);
  }

 private:
  void classify(const xgm::penalty::GreyView& view, xgm::Direction r, int y,
                std::span<std::uint8_t> classes) const {
    std::vector<float> changes(classes.size());
    view.differences(r, y, changes);
    std::transform(changes.begin(), changes.end(), classes.begin(),
                   [tau = tau_](float change) { return static_cast<std::uint8_t>(change > tau); });
  }

  xgm::penalty::GreyView base_, match_;
  Parameters parameters_;
  float tau_;
};

class TwoImageGradient final : public xgm::Penalty {
 public:
  using Parameters = ::Parameters;

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    xgm::penalty::describe(p.weights, set);
    set.add("tau", p.tau, "A change of intensity along the path counts if it is above this.")
        .unit("grey levels")
        .range(0, 255);
    set.add("q1", p.q1, "P1 and P2 are divided by this where the intensity changes in one view.")
        .range(1, 100);
    set.add("q2", p.q2, "P1 and P2 are divided by this where it changes in both views.")
        .range(1, 100);
    set.add("v", p.v,
            "P1 is divided by this on vertical paths, multiplied by sqrt(1 + v^2) / v on diagonal "
            "ones and knight's moves.")
        .range(1, 10);
    set.rule({"q2", "q1"}, "must not be below q1", [&p] { return p.q2 >= p.q1; });
  }

  explicit TwoImageGradient(const Parameters& p) : parameters_(p) {}

  std::unique_ptr<const xgm::PenaltyField> run(const xgm::ImagePair& pair,
                                               const xgm::Context&) const override {
    return std::make_unique<Field>(pair, parameters_);
  }

 private:
  Parameters parameters_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<TwoImageGradient>(
      "two_image_gradient",
      "P1 and P2 depend on the change of intensity along the path in both views.",
      "Patil et al., A comparative evaluation of SGM variants (including a new variant, tMGM) for "
      "dense stereo matching, section 5; after Zbontar & LeCun, JMLR 2016");
}
