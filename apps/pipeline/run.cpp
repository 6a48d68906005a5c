// SPDX-License-Identifier: Apache-2.0
// pipeline run: match a pair of images.
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>

#include "common.hpp"
#include "console.hpp"
#include "explain_pixels.hpp"
#include "output_folder.hpp"
#include "run_depth.hpp"
#include "run_inputs.hpp"
#include "run_memory.hpp"
#include "run_observer.hpp"
#include "run_options.hpp"
#include "run_results.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/io/outputs.hpp"

namespace xgm::cli {
namespace {

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

RunRecord begin_record(const RunOptions& options, const NamedPipeline& named,
                       const std::vector<Override>& overrides, const Plan& plan) {
  RunRecord record;
  record.pipeline_file = named.file;
  record.resolved_pipeline = named.pipeline.resolved_json();
  record.overrides = overrides;
  record.disparities_from = plan.disparities_from;
  record.threads = threads_of(options);
  return record;
}

/// What was asked for beside the map.
struct Extras {
  std::optional<DepthPlan> depth;
  ExplainPixels explained;
};

int run_checked(const RunOptions& options, const Pipeline& pipeline, const Plan& plan,
                const Extras& extras, RunRecord record) {
  Progress progress;
  progress.begin("reading the images");
  const Stopwatch reading;
  auto [scene, range] = read_inputs(options, plan);
  record.reading_seconds = reading.seconds();
  record.scene = scene.name;
  record.inputs = scene.inputs;
  record.size = scene.pair.size();
  record.disparities = range.hull();

  Dumper dumper((std::filesystem::path(options.output) / "dump").string(), options.dump);
  RunObserver observer(progress, dumper);
  LevelCollector levels;
  if (options.report) observer.show_to(levels);
  const auto explainer = make_explainer(extras.explained, scene);
  if (!extras.explained.empty()) observer.show_to(*explainer);
  const MatchRequest request{std::move(scene.pair), range, {}};
  guard_memory(
      pipeline, request,
      {.load = workload_of(request, record.threads), .truth = !scene.truth.disparity.empty()},
      plan.memory_limit);
  progress.begin("matching");
  const Stopwatch matching;
  // Shares its pixels.
  const Image left = extras.depth || options.report ? request.pair.base : Image();
  const MatchResult result =
      pipeline.run(request, {.observer = &observer, .threads = options.threads});
  record.matching_seconds = matching.seconds();

  progress.begin("writing the results");
  const DisparityMap& map = result.forward;
  record.stages = observer.stages();
  record.warnings = observer.warnings();
  record.dumps = dumper.files();
  if (!options.dump.empty() && record.dumps.empty()) {
    spdlog::warn("--dump {}: no stage has such a path; run.json lists the paths", options.dump);
  }
  record.valid_share = map.density();
  record.status_shares = status_shares(map);
  if (!scene.truth.disparity.empty()) {
    record.truth = evaluate_regions(map, scene.truth, {.deltas = usual_thresholds()});
  }
  record.peak_memory_bytes = peak_memory();
  const std::string depth_text = extras.depth ? write_depth_files(*extras.depth, map, left) : "";
  const std::string explanations =
      extras.explained.empty() ? "" : to_json(explainer->explanations());
  if (!explanations.empty()) write_explanations(options.output, explanations);
  if (options.report) {
    write_report(options.output, record, left, scene.truth,
                 {.name = {},
                  .record_json = {},
                  .map = map,
                  .levels = levels.levels(),
                  .explanations_json = explanations});
  }
  write_results(options.output, map, record);
  progress.end();
  print_summary(options.output, record, options.report);
  std::cout << depth_text << std::flush;
  return judge(map, record);
}

int run(const RunOptions& options, const std::vector<std::string>& command_line) {
  set_up_logging(options.log_level);
  set_opencv_threads(options.threads);
  const std::vector<Override> overrides = parse_overrides(options.assignments);
  const Registry registry = make_registry(options.plugins);
  const auto named = load_named(options.pipeline, registry, overrides);
  if (!named) return kUsage;
  const Plan plan = make_plan(options, named->pipeline, registry);
  const Extras extras{plan_depth(options, plan), parse_explain(options.explain)};
  make_output_folder("--output ", options.output);
  RunRecord record = begin_record(options, *named, overrides, plan);
  record.command_line = command_line;
  return run_checked(options, named->pipeline, plan, extras, std::move(record));
}

}  // namespace

void add_run(CLI::App& app, Invocation& call) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Match a pair of images");
  add_run_options(*command, *options);
  command->callback([options, &call] { call.exit_code = run(*options, call.arguments); });
}

}  // namespace xgm::cli
