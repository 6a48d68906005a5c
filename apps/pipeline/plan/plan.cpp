// SPDX-License-Identifier: Apache-2.0
// pipeline plan: what will a run take?
#include "xgm/pipeline/plan.hpp"

#include <spdlog/fmt/fmt.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/scene_request.hpp"
#include "options/values.hpp"
#include "terminal/console.hpp"
#include "terminal/observer.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/text.hpp"
#include "xgm/synthesis/plain_scene.hpp"

namespace xgm::cli {
namespace {

struct Options : SceneOptions {
  std::string size;
  bool all_stages = false;
  bool json = false;
};

/// A matcher without matchers inside stands for its stages: one view of one level.
bool is_shown(const std::vector<PlannedStage>& stages, std::size_t i) {
  const auto lies_in = [](const PlannedStage& inner, const PlannedStage& outer) {
    return outer.kind == "matcher" && inner.path.starts_with(outer.path + '.');
  };
  const auto lies_here = [&](const PlannedStage& stage) { return lies_in(stage, stages[i]); };
  const auto holds_this = [&](const PlannedStage& stage) {
    return lies_in(stages[i], stage) &&
           std::none_of(stages.begin(), stages.end(), [&](const PlannedStage& inner) {
             return inner.kind == "matcher" && lies_in(inner, stage);
           });
  };
  const bool holds_matcher = std::any_of(stages.begin(), stages.end(), [&](const auto& stage) {
    return stage.kind == "matcher" && lies_here(stage);
  });
  return !holds_matcher && std::none_of(stages.begin(), stages.end(), holds_this);
}

/// Its own and those of the stages inside.
double seconds_with_inner(const std::vector<PlannedStage>& stages, const PlannedStage& outer) {
  double seconds = 0;
  for (const PlannedStage& stage : stages) {
    if (stage.path == outer.path || stage.path.starts_with(outer.path + '.')) {
      seconds += stage.seconds;
    }
  }
  return seconds;
}

void print_table(const RunPlan& plan, bool all_stages) {
  std::size_t width = std::string("stage").size();
  for (const PlannedStage& stage : plan.stages) width = std::max(width, stage.path.size());
  const auto row = [&](const auto&... cells) {
    std::cout << fmt::format("{:<{}}  {:>12}  {:>8}  {:>9}  {:>9}  {:>8}\n", cells...);
  };
  row("stage", width, "size", "cells/px", "M cells", "memory", "seconds");
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    const PlannedStage& stage = plan.stages[i];
    if (!all_stages && !is_shown(plan.stages, i)) continue;
    const Workload& load = stage.load;
    const bool has_cells = stage.kind != "preprocess" && stage.kind != "filter" &&
                           stage.kind != "consistency" && stage.kind != "penalty";
    row(stage.path, width, fmt::format("{} x {}", load.size.width, load.size.height),
        has_cells ? fmt::format("{}{:.0f}", load.estimated ? "~" : "", load.cells_per_pixel) : "",
        has_cells ? fmt::format("{:.1f}", load.cells() / 1e6) : "", bytes_text(stage.memory),
        fmt::format("{:.2f}", seconds_with_inner(plan.stages, stage)));
  }
}

void print(const Options& options, const RunPlan& plan, const PlanRequest& request) {
  const Workload& load = request.load;
  std::cout << fmt::format("{}: {} x {} px, {} disparities ({} to {}), {} thread{}\n\n",
                           options.pipeline, load.size.width, load.size.height, load.range.size(),
                           load.range.begin, load.range.end - 1, load.threads,
                           load.threads == 1 ? "" : "s");
  print_table(plan, options.all_stages);
  std::cout << "\nmemory: " << bytes_text(plan.peak_bytes) << " at most, in " << plan.peak_stage
            << '\n';
  if (plan.estimated) {
    std::cout << (request.experience.narrowing
                      ? "        ~ as far as a run on smaller images tells of these\n"
                      : "        ~ typical; what finer levels search depends on the scene\n");
  }
  std::cout << fmt::format("time:   about {:.1f} s of matching\n", plan.seconds) << std::flush;
}

cv::Size parse_size(const std::string& text) {
  const std::size_t by = text.find('x');
  const auto width = parse_whole(std::string_view(text).substr(0, by));
  const auto height =
      by == std::string::npos ? std::nullopt : parse_whole(std::string_view(text).substr(by + 1));
  constexpr int kMax = 1'000'000;
  if (!width || !height || *width < 1 || *height < 1 || *width > kMax || *height > kMax) {
    throw UsageError("--size " + text + ": write WIDTHxHEIGHT in px, for example 2964x1988");
  }
  return {*width, *height};
}

/// Nothing but a size is known: colour images, every pixel with data.
PlanRequest request_of_size(const Options& options, const Pipeline& pipeline, int threads) {
  const cv::Size size = parse_size(options.size);
  Interval disparities;
  if (!options.disparities.empty()) {
    disparities = parse_disparities(options.disparities);
  } else if (pipeline.disparities()) {
    disparities = *pipeline.disparities();
  } else {
    throw UsageError("--size needs --disparities MIN:MAX, too, unless the pipeline says them");
  }
  const Interval possible = clip_to_width(disparities, size.width);
  if (possible.empty()) {
    throw UsageError("--disparities " + options.disparities + " cannot be seen in images " +
                     std::to_string(size.width) + " px wide; give a smaller range");
  }
  constexpr int kColour = 3;
  PlanRequest request{.load = Workload::dense(size, kColour, possible)};
  request.load.threads = threads;
  synthesis::PlainOptions pair;
  pair.size = {512, 384};
  pair.disparities = {0, 64};
  pair.colour = true;
  synthesis::GeneratedScene scene = synthesis::generate_plain(pair);
  const auto range = DisparityRange::uniform(scene.pair.size(), scene.disparities);
  request.experience = probe_whole(pipeline, {std::move(scene.pair), range, {}}, threads);
  request.experience.narrowing.reset();
  return request;
}

PlanRequest request_of_scene(const SceneRequest& scene, const Pipeline& pipeline, int threads) {
  SceneInputs inputs = read_scene(scene, pipeline);
  show_notes(inputs);
  const MatchRequest match{std::move(inputs.scene.pair), inputs.range, {}};
  return {.load = workload_of(match, threads),
          .truth = !inputs.scene.truth.disparity.empty(),
          .experience = probe(pipeline, match, threads)};
}

int plan(const Options& options) {
  set_up_logging(options.log_level);
  const Registry registry = make_registry(options.plugins);
  const auto named = load_named(options.pipeline, registry, parse_overrides(options.assignments));
  if (!named) return kUsage;
  const Pipeline& pipeline = *named;
  const int threads = use_threads(options.threads);
  Progress progress;
  progress.begin("measuring the speed of this machine");
  const PlanRequest request =
      options.size.empty() ? request_of_scene(scene_request(options, registry), pipeline, threads)
                           : request_of_size(options, pipeline, threads);
  progress.end();
  const RunPlan planned = plan_run(pipeline, request);
  if (options.json) {
    std::cout << to_json(planned, request);
  } else {
    print(options, planned, request);
  }
  return kOk;
}

void add_plan_options(CLI::App& command, Options& options) {
  add_pipeline(command, options);
  add_scene_or_images(command, options);
  auto* range_maps = add_search(command, options);
  command.add_option("--size", options.size, "In place of a scene: the size of colour images, px")
      ->type_name("WxH")
      ->excludes(command.get_option("scene"))
      ->excludes(command.get_option("--left"))
      ->excludes(range_maps);
  add_matching(command, options);
  add_surroundings(command, options);
}

}  // namespace

void add_plan(CLI::App& app, Invocation& call) {
  auto options = std::make_shared<Options>();
  CLI::App& command = add_command(app, call, "plan", "Predict the memory and the time of a run",
                                  [options] { return plan(*options); });
  add_plan_options(command, *options);
  command.add_flag("--stages", options->all_stages, "Show every stage of every level and view");
  command.add_flag("--json", options->json, "For programs: all stages, as an object");
}

}  // namespace xgm::cli
