// SPDX-License-Identifier: Apache-2.0
// One pipeline's figures over the scenes of a set.
#include <algorithm>
#include <limits>

#include "xgm/evaluation/bench_tables.hpp"

namespace xgm {
namespace {

/// Every figure of an evaluation; thresholds apart.
constexpr double Evaluation::*kFigures[] = {
    &Evaluation::invalid, &Evaluation::average_error, &Evaluation::rms, &Evaluation::a50,
    &Evaluation::a90,     &Evaluation::a95,           &Evaluation::a99, &Evaluation::d1};

/// Weighted mean of evaluations by the same thresholds. NaN in one is NaN in all.
class MeanEvaluation {
 public:
  void add(const Evaluation& evaluation, double weight) {
    weight_ += weight;
    sum_.judged += evaluation.judged;
    for (const auto figure : kFigures) sum_.*figure += weight * evaluation.*figure;
    sum_.at.resize(evaluation.at.size());
    for (std::size_t i = 0; i < sum_.at.size(); ++i) {
      sum_.at[i].delta = evaluation.at[i].delta;
      sum_.at[i].bad += weight * evaluation.at[i].bad;
    }
  }

  Evaluation mean() const {
    Evaluation mean = sum_;
    const double share = weight_ > 0 ? 1 / weight_ : std::numeric_limits<double>::quiet_NaN();
    for (const auto figure : kFigures) mean.*figure *= share;
    for (ThresholdScore& score : mean.at) {
      score.bad *= share;
      score.total = mean.invalid + score.bad;
    }
    return mean;
  }

 private:
  double weight_ = 0;
  Evaluation sum_;
};

}  // namespace

std::vector<std::string> sets(const BenchResult& result) {
  std::vector<std::string> names;
  for (const BenchScene& scene : result.request.scenes) {
    if (std::find(names.begin(), names.end(), scene.set) == names.end()) names.push_back(scene.set);
  }
  return names;
}

BenchAverage average(const BenchResult& result, std::size_t pipeline, const std::string& set) {
  BenchAverage average;
  average.comparable = true;
  BenchCell& figures = average.figures;
  MeanEvaluation mean;
  bool has_truth = false;
  for (std::size_t i = 0; i < result.request.scenes.size(); ++i) {
    const BenchScene& scene = result.request.scenes[i];
    if (scene.set != set) continue;
    ++average.of;
    const BenchCell& cell = result.at(pipeline, i);
    if (cell.state != CellState::done) {
      if (result.any_done(i)) average.comparable = false;
      continue;
    }
    ++average.scenes;
    figures.seconds += cell.seconds;
    figures.density += cell.density;
    figures.evaluations += cell.evaluations;
    figures.peak_bytes = std::max(figures.peak_bytes, cell.peak_bytes);
    if (const Evaluation* evaluation = judged(cell, result.rules)) {
      mean.add(*evaluation, scene.files.weight);
      has_truth = true;
    }
  }
  if (average.scenes == 0) return average;
  const auto count = static_cast<double>(average.scenes);
  figures.state = CellState::done;
  figures.density /= count;
  figures.evaluations /= count;  // like the seconds: their quotient is that of the sums
  figures.seconds /= count;
  const std::string& region = result.rules.region;
  if (has_truth) figures.regions.push_back({region.empty() ? "all" : region, mean.mean()});
  return average;
}

}  // namespace xgm
