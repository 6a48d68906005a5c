// SPDX-License-Identifier: Apache-2.0
// Several confidences as one.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "xgm/plugin.hpp"

namespace {

enum class Mean { arithmetic, geometric };

/// A confidence that can tell nothing of a pixel (NaN) leaves the pixel without any.
class Weighted final : public xgm::Confidence {
 public:
  struct Parameters {
    xgm::SlotList<xgm::Confidence> confidences;
    std::vector<double> weights;
    Mean mean = Mean::arithmetic;
  };

  static void describe(Parameters& p, xgm::ParameterSet& set) {
    set.add("confidences", p.confidences, "The confidences to take the mean of.");
    set.add("weights", p.weights, "Weight of each confidence, in their order.").range(0, 1e6);
    set.add_choice("mean", p.mean,
                   "arithmetic: one can make up for another; geometric: where one is 0, so is the "
                   "mean.",
                   {{"arithmetic", Mean::arithmetic}, {"geometric", Mean::geometric}});
    set.rule({"weights", "confidences"}, "must have one number for each of confidences",
             [&p] { return p.weights.size() == p.confidences.size(); });
    set.rule({"weights"}, "must have at least one number above 0",
             [&p] { return std::accumulate(p.weights.begin(), p.weights.end(), 0.0) > 0; });
  }

  explicit Weighted(Parameters p) : p_(std::move(p)) {}

  bool needs_sums() const override {
    return any([](const xgm::Confidence& part) { return part.needs_sums(); });
  }
  bool needs_other_view() const override {
    return any([](const xgm::Confidence& part) { return part.needs_other_view(); });
  }
  bool needs_confidence() const override {
    return any([](const xgm::Confidence& part) { return part.needs_confidence(); });
  }

  cv::Mat1f run(const xgm::Evidence& evidence, const xgm::Context& context) const override {
    const double all = std::accumulate(p_.weights.begin(), p_.weights.end(), 0.0);
    const auto count = static_cast<double>(p_.confidences.size());
    cv::Mat1d sum(evidence.map.size(), 0.0);
    std::size_t i = 0;
    for (const auto& confidence : p_.confidences) {
      const auto done = static_cast<double>(i);
      const cv::Mat1f part = confidence(context.part(done / count, (done + 1) / count), evidence);
      add(part, p_.weights[i++] / all, sum);
    }
    return mean_of(sum);
  }

 private:
  template <class Question>
  bool any(const Question& question) const {
    return std::any_of(p_.confidences.begin(), p_.confidences.end(),
                       [&](const auto& part) { return question(part.stage()); });
  }

  bool is_geometric() const { return p_.mean == Mean::geometric; }

  /// A weight of 0 changes nothing; 0 * log(0) would be NaN.
  void add(const cv::Mat1f& part, double weight, cv::Mat1d& sum) const {
    if (weight == 0) return;
    xgm::parallel_for(0, sum.rows, [&](int y) {
      for (int x = 0; x < sum.cols; ++x) {
        const double sure = part(y, x);
        sum(y, x) += weight * (is_geometric() ? std::log(sure) : sure);
      }
    });
  }

  /// Rounding must not lead beyond 1.
  cv::Mat1f mean_of(const cv::Mat1d& sum) const {
    cv::Mat1f mean(sum.size());
    xgm::parallel_for(0, sum.rows, [&](int y) {
      for (int x = 0; x < sum.cols; ++x) {
        const double sure = is_geometric() ? std::exp(sum(y, x)) : sum(y, x);
        mean(y, x) = static_cast<float>(sure > 1 ? 1 : sure);
      }
    });
    return mean;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Weighted>("weighted", "The weighted mean of several confidences.");
}
