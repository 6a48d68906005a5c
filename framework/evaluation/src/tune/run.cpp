// SPDX-License-Identifier: Apache-2.0
// Rung by rung, each a bench whose finished runs the next one finds done.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "xgm/base/error.hpp"
#include "xgm/base/random.hpp"
#include "xgm/evaluation/bench_tables.hpp"
#include "xgm/evaluation/tune.hpp"

namespace xgm {
namespace {

using Indices = std::vector<std::size_t>;

Indices shuffled_scenes(std::size_t count, std::uint64_t seed) {
  Indices scenes(count);
  std::iota(scenes.begin(), scenes.end(), std::size_t{0});
  Random random(seed);
  for (std::size_t i = count; i-- > 1;) {
    std::swap(scenes[i], scenes[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  }
  return scenes;
}

void require_truths(const std::vector<BenchScene>& scenes) {
  for (const BenchScene& scene : scenes) {
    if (!scene.files.truth.disparity.file.empty()) continue;
    throw UsageError("scene '" + scene.files.name +
                     "' has no ground truth to judge by; name the scenes that have with --scenes");
  }
}

/// The weighted mean of the total error at the first threshold.
TunedPipeline judged_pipeline(const BenchResult& result, std::size_t row, std::size_t pipeline) {
  TunedPipeline tuned{.pipeline = pipeline, .scenes = result.request.scenes.size()};
  double weights = 0;
  for (std::size_t scene = 0; scene < tuned.scenes; ++scene) {
    const BenchCell& cell = result.at(row, scene);
    const Evaluation* const evaluation =
        cell.state == CellState::done ? judged(cell, result.rules) : nullptr;
    if (evaluation == nullptr) {
      tuned.error = std::numeric_limits<double>::infinity();
      tuned.failure = result.request.scenes[scene].files.name + ": " +
                      (cell.failure.empty() ? "nothing to judge by" : cell.failure);
      return tuned;
    }
    const double weight = result.request.scenes[scene].files.weight;
    weights += weight;
    tuned.error += weight * evaluation->at.front().total;
  }
  tuned.error /= weights;
  return tuned;
}

class Tuning {
 public:
  Tuning(const TuneRequest& request, const BenchHooks& hooks) : hooks_(hooks) {
    result_.request = request;
    const std::size_t scenes = request.bench.scenes.size();
    const Indices order = shuffled_scenes(scenes, request.seed);
    const auto held = static_cast<std::ptrdiff_t>(held_out_count(request.held_out, scenes));
    result_.held_out.assign(order.begin(), order.begin() + held);
    result_.tuning.assign(order.begin() + held, order.end());
  }

  TuneResult run() {
    halve();
    if (!result_.interrupted) judge_held_out();
    return std::move(result_);
  }

 private:
  void halve() {
    const auto rungs = plan_rungs(result_.request.bench.pipelines.size(), result_.tuning.size());
    Indices left(rungs.front().pipelines);
    std::iota(left.begin(), left.end(), std::size_t{0});
    std::vector<TunedPipeline> dropped;
    for (std::size_t i = 0; i < rungs.size() && !result_.interrupted; ++i) {
      std::vector<TunedPipeline> ranked = bench(left, first_scenes(rungs[i].scenes));
      rank(ranked);
      const std::size_t kept = i + 1 < rungs.size() ? rungs[i + 1].pipelines : ranked.size();
      keep_start(ranked, kept);
      left.clear();
      for (std::size_t k = 0; k < kept; ++k) left.push_back(ranked[k].pipeline);
      if (kept < ranked.size()) {
        dropped.insert(dropped.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(kept),
                       ranked.end());
        ranked.resize(kept);
      }
      result_.ranking = ranked;
    }
    rank(result_.ranking);
    result_.ranking.insert(result_.ranking.end(), dropped.begin(), dropped.end());
  }

  Indices first_scenes(std::size_t count) const {
    return {result_.tuning.begin(), result_.tuning.begin() + static_cast<std::ptrdiff_t>(count)};
  }

  static void rank(std::vector<TunedPipeline>& pipelines) {
    std::ranges::stable_sort(pipelines, [](const TunedPipeline& a, const TunedPipeline& b) {
      return a.error != b.error ? a.error < b.error : a.pipeline < b.pipeline;
    });
  }

  /// What is to be bettered is compared on all scenes, however bad it is.
  static void keep_start(std::vector<TunedPipeline>& ranked, std::size_t kept) {
    const auto start = std::ranges::find(ranked, std::size_t{0}, &TunedPipeline::pipeline);
    const auto last = ranked.begin() + static_cast<std::ptrdiff_t>(kept) - 1;
    if (start > last) std::rotate(last, start, start + 1);
  }

  std::vector<TunedPipeline> bench(const Indices& pipelines, const Indices& scenes) {
    BenchRequest part = result_.request.bench;
    part.pipelines.clear();
    part.scenes.clear();
    for (const std::size_t i : pipelines)
      part.pipelines.push_back(result_.request.bench.pipelines[i]);
    for (const std::size_t i : scenes) part.scenes.push_back(result_.request.bench.scenes[i]);
    const BenchResult result = run_bench(part, result_.request.rules, hooks_);
    result_.interrupted = result.interrupted;
    std::vector<TunedPipeline> tuned;
    for (std::size_t row = 0; row < pipelines.size(); ++row) {
      tuned.push_back(judged_pipeline(result, row, pipelines[row]));
    }
    return tuned;
  }

  void judge_held_out() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    result_.error_before = result_.error_after = kNone;
    result_.runs =
        runs_of(plan_rungs(result_.request.bench.pipelines.size(), result_.tuning.size()));
    if (result_.held_out.empty()) return;
    Indices pipelines{0};
    if (result_.best().pipeline != 0) pipelines.push_back(result_.best().pipeline);
    const std::vector<TunedPipeline> judged = bench(pipelines, result_.held_out);
    result_.error_before = judged.front().error;
    result_.error_after = judged.back().error;
    result_.runs += pipelines.size() * result_.held_out.size();
  }

  const BenchHooks& hooks_;
  TuneResult result_;
};

}  // namespace

const TunedPipeline& TuneResult::start() const {
  return *std::ranges::find(ranking, std::size_t{0}, &TunedPipeline::pipeline);
}

TuneResult run_tune(const TuneRequest& request, const BenchHooks& hooks) {
  require_truths(request.bench.scenes);
  return Tuning(request, hooks).run();
}

}  // namespace xgm
