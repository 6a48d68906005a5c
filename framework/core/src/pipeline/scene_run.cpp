// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/scene_run.hpp"

#include "base/stopwatch.hpp"
#include "pipeline/memory_guard.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/stage/observers.hpp"

namespace xgm {
namespace {

class Warnings final : public Observer {
 public:
  explicit Warnings(std::vector<std::string>& texts) : texts_(texts) {}
  void log(LogLevel level, const StagePlace& place, const std::string& text) override {
    if (level != LogLevel::warning) return;
    texts_.push_back(place.path.empty() ? text : place.path + ": " + text);
  }

 private:
  std::vector<std::string>& texts_;
};

void tell(const SceneInputs& inputs, Observer& observer) {
  for (const std::string& note : inputs.scene.notes) observer.log(LogLevel::info, {}, note);
  for (const std::string& warning : inputs.warnings) observer.log(LogLevel::warning, {}, warning);
}

void guard(const Pipeline& pipeline, const MatchRequest& request, const SceneInputs& inputs,
           const RunOptions& options, Observer& observer) {
  const int threads = options.threads > 0 ? options.threads : thread_count();
  const PlanRequest plan{.load = workload_of(request, threads),
                         .truth = !inputs.scene.truth.disparity.empty(),
                         .besides = inputs.besides};
  const std::string warning = guard_memory(pipeline, request, plan, inputs.memory_limit, options);
  if (!warning.empty()) observer.log(LogLevel::warning, {}, warning);
}

}  // namespace

SceneRun match_scene(const Pipeline& pipeline, SceneInputs inputs, const RunOptions& options,
                     const MatchScene& match) {
  std::vector<std::string> texts;
  Warnings warnings(texts);
  Observers observers;
  observers.add(warnings);
  if (options.observer != nullptr) observers.add(*options.observer);
  tell(inputs, observers);
  RunOptions observed = options;
  observed.observer = &observers;
  observed.facts.scene = inputs.scene.name;
  observed.facts.calibration = inputs.scene.calibration;
  const MatchRequest request{inputs.scene.pair, inputs.range, {}};
  if (!match) guard(pipeline, request, inputs, options, observers);
  const Stopwatch matching;
  MatchResult maps = match ? match(inputs, observed) : pipeline.run(request, observed);
  const double seconds = matching.seconds();
  return {.scene = std::move(inputs.scene),
          .disparities = inputs.range.hull(),
          .disparities_from = std::move(inputs.disparities_from),
          .maps = std::move(maps),
          .warnings = std::move(texts),
          .reading_seconds = inputs.reading_seconds,
          .matching_seconds = seconds};
}

SceneRun run_scene(const Pipeline& pipeline, const SceneRequest& request,
                   const RunOptions& options) {
  return match_scene(pipeline, read_scene(request, pipeline), options);
}

}  // namespace xgm
