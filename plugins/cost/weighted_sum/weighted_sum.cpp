// SPDX-License-Identifier: Apache-2.0
// Cost "weighted_sum": several costs at once.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "xgm/plugin.hpp"

namespace {

constexpr double kLargestCost = 254;  // 255 says: no match

class WeightedSum final : public xgm::Cost {
 public:
  struct Parameters {
    xgm::SlotList<xgm::Cost> costs;
    std::vector<double> weights;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("costs", p.costs,
            "The costs to add; a cell that one of them cannot match has no match.");
    set.add("weights", p.weights,
            "Factor of each cost, in their order; the sum is rounded, and 254 at most.")
        .range(0, 254);
    set.rule({"weights", "costs"}, "must have one number for each of costs",
             [&p] { return p.weights.size() == p.costs.size(); });
    set.rule({"weights"}, "must have at least one number above 0",
             [&p] { return std::accumulate(p.weights.begin(), p.weights.end(), 0.0) > 0; });
  }

  explicit WeightedSum(const Parameters& p) : costs_(p.costs), weights_(p.weights) {}

  xgm::CostVolume run(const xgm::ImagePair& pair, const xgm::VolumeShapePtr& shape,
                      const xgm::Context& context) const override {
    std::vector<xgm::CostVolume> terms;
    const auto count = static_cast<double>(costs_.size());
    for (const xgm::Slot<xgm::Cost>& cost : costs_) {
      const auto done = static_cast<double>(terms.size());
      terms.push_back(cost(context.part(done / count, (done + 1) / count), pair, shape));
    }
    // The sum takes the place of the first term, cell by cell: volumes are large.
    const int last = shape->width() - 1;
    xgm::parallel_for(0, shape->height(), [&](int y) {
      const std::int64_t end = shape->offset(y, last) + shape->count(y, last);
      for (std::int64_t i = shape->offset(y, 0); i < end; ++i) terms[0].data()[i] = sum(terms, i);
    });
    double bound = 0;
    for (std::size_t k = 0; k < terms.size(); ++k) bound += weights_[k] * terms[k].max_cost;
    terms[0].max_cost = rounded(bound);
    return std::move(terms[0]);
  }

 private:
  std::uint8_t sum(const std::vector<xgm::CostVolume>& terms, std::int64_t i) const {
    double result = 0;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      const std::uint8_t cell = terms[k].data()[i];
      if (cell == xgm::CostVolume::kNoMatch) return cell;
      result += weights_[k] * cell;
    }
    return rounded(result);
  }

  static std::uint8_t rounded(double cost) {
    return static_cast<std::uint8_t>(std::floor(std::min(cost, kLargestCost) + 0.5));
  }

  xgm::SlotList<xgm::Cost> costs_;
  std::vector<double> weights_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<WeightedSum>("weighted_sum", "Weighted sum of other costs, 254 at most.");
}
