// SPDX-License-Identifier: Apache-2.0
// pipeline run: match a pair of images.
#include <spdlog/spdlog.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "common.hpp"
#include "console.hpp"
#include "explain_pixels.hpp"
#include "run.hpp"
#include "run_inputs.hpp"
#include "run_observer.hpp"
#include "run_options.hpp"
#include "run_results.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/outputs.hpp"
#include "xgm/memory.hpp"

namespace xgm::cli {
namespace {

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

void make_folder(const std::string& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (!std::filesystem::is_directory(folder)) {
    throw UsageError("--output " + folder + ": cannot be made: " + failure.message());
  }
  try {  // a folder that cannot be written to should not cost the user a run
    const std::string trial = (std::filesystem::path(folder) / ".writable").string();
    write_file(trial, "");
    std::filesystem::remove(trial, failure);
  } catch (const Error& error) {
    throw UsageError("--output " + error.message());
  }
}

}  // namespace

/// Before matching: a mistake in these files should not cost the user a run.
void read_truth(const RunOptions& options, Scene& scene) {
  if (options.truth.empty()) return;
  scene.truth = {.disparity = read_disparities(options.truth, options.truth_divisor)};
  scene.inputs.push_back({"truth", options.truth, identify_file(options.truth)});
  if (!options.truth_mask.empty()) {
    scene.truth.non_occluded = read_mask(options.truth_mask);
    scene.inputs.push_back({"truth mask", options.truth_mask, identify_file(options.truth_mask)});
  }
  // All that can be wrong with it is found by judging an empty map.
  evaluate(DisparityMap(scene.pair.size()), scene.truth.disparity, {}, scene.truth.non_occluded);
}

void guard_memory(const DisparityRange& range) {
  const std::uint64_t available = available_memory();
  limit_memory(available);
  const double cells = static_cast<double>(range.size().area()) * range.hull().size();
  constexpr double kBytesPerCell = 3;  // costs and sums of a matcher without pyramid
  if (cells * kBytesPerCell > static_cast<double>(available)) {
    spdlog::warn(
        "{} x {} pixels x {} disparities take about {:.1f} GB unless matched in a "
        "pyramid, and {:.1f} GB are free; if memory runs out, use a pyramid pipeline or "
        "a narrower range",
        range.size().width, range.size().height, range.hull().size(), cells * kBytesPerCell / 1e9,
        static_cast<double>(available) / 1e9);
  }
}

namespace {

RunRecord begin_record(const RunOptions& options, const NamedPipeline& named,
                       const std::vector<Override>& overrides, const Plan& plan) {
  RunRecord record;
  record.pipeline_file = named.file;
  record.resolved_pipeline = named.pipeline.resolved_json();
  record.overrides = overrides;
  record.disparities_from = plan.disparities_from;
  record.threads = options.threads > 0 ? options.threads : thread_count();
  return record;
}

int run_checked(const RunOptions& options, const Pipeline& pipeline, const Plan& plan,
                const ExplainPixels& explained, RunRecord record) {
  Progress progress;
  progress.begin("reading the images");
  const Stopwatch reading;
  Scene scene = read_scene(plan);
  const DisparityRange range = make_range(plan, scene);
  read_truth(options, scene);
  for (const std::string& note : scene.notes) spdlog::info(note);
  record.reading_seconds = reading.seconds();
  record.scene = scene.name;
  record.inputs = scene.inputs;
  record.size = scene.pair.size();
  record.disparities = range.hull();

  guard_memory(range);
  Dumper dumper((std::filesystem::path(options.output) / "dump").string(), options.dump);
  RunObserver observer(progress, dumper);
  const auto explainer = make_explainer(explained, scene);
  if (!explained.empty()) observer.show_to(*explainer);
  progress.begin("matching");
  const Stopwatch matching;
  const MatchResult result =
      pipeline.run({std::move(scene.pair), range, {}}, observer, options.threads);
  record.matching_seconds = matching.seconds();

  progress.begin("writing the results");
  const DisparityMap& map = result.forward;
  record.stages = observer.stages();
  record.warnings = observer.warnings();
  record.dumps = dumper.files();
  if (!options.dump.empty() && record.dumps.empty()) {
    spdlog::warn("--dump {}: no stage has such a path; run.json lists the paths", options.dump);
  }
  record.valid_share = map.valid_share();
  record.status_shares = status_shares(map);
  if (!scene.truth.disparity.empty()) {
    record.truth = evaluate_regions(map, scene.truth, {.deltas = usual_thresholds()});
  }
  record.peak_memory_bytes = peak_memory();
  if (!explained.empty()) write_explanations(options.output, explainer->explanations());
  write_results(options.output, map, record);
  progress.end();
  print_summary(options.output, record);
  return judge(map, record);
}

int run(const RunOptions& options, const std::vector<std::string>& command_line) {
  set_up_logging(options.log_level);
  const std::vector<Override> overrides = parse_overrides(options.assignments);
  const Registry registry = make_registry(options.plugins);
  const auto named = load_named(options.pipeline, registry, overrides);
  if (!named) return kUsage;
  const Plan plan = make_plan(options, named->pipeline);
  const ExplainPixels explained = parse_explain(options.explain);
  make_folder(options.output);
  RunRecord record = begin_record(options, *named, overrides, plan);
  record.command_line = command_line;
  return run_checked(options, named->pipeline, plan, explained, std::move(record));
}

}  // namespace

void add_run(CLI::App& app, Invocation& call) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Match a pair of images");
  add_run_options(*command, *options);
  command->callback([options, &call] { call.exit_code = run(*options, call.arguments); });
}

}  // namespace xgm::cli
