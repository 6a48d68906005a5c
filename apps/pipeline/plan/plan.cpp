// SPDX-License-Identifier: Apache-2.0
// pipeline plan: what will a run take?
#include "xgm/pipeline/plan.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/satellites.hpp"
#include "options/scene_request.hpp"
#include "options/surfaces.hpp"
#include "options/values.hpp"
#include "plan/plan_surface.hpp"
#include "terminal/console.hpp"
#include "terminal/observer.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/text.hpp"
#include "xgm/evaluation/plan_json.hpp"
#include "xgm/synthesis/generate.hpp"

namespace xgm::cli {
namespace {

struct Options : SceneOptions {
  SatelliteFiles satellites;
  std::string size;
  bool all_stages = false;
  bool json = false;
};

/// The stages inside follow a stage; the index behind the last of them.
std::size_t end_of(const std::vector<PlannedStage>& stages, std::size_t i) {
  std::size_t end = i + 1;
  while (end < stages.size() && stages[end].place.depth > stages[i].place.depth) ++end;
  return end;
}

/// A matcher without matchers inside stands for its stages: one view of one level.
std::vector<bool> shown(const std::vector<PlannedStage>& stages) {
  std::vector<bool> shown(stages.size(), true);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (stages[i].place.kind != "matcher") continue;
    const std::size_t end = end_of(stages, i);
    const auto at = [&](std::size_t k) { return stages.begin() + static_cast<std::ptrdiff_t>(k); };
    const bool holds_matcher = std::any_of(at(i + 1), at(end), [](const PlannedStage& stage) {
      return stage.place.kind == "matcher";
    });
    if (holds_matcher) {
      shown[i] = false;
    } else {
      for (std::size_t k = i + 1; k < end; ++k) shown[k] = false;
    }
  }
  return shown;
}

/// Its own and those of the stages inside.
double seconds_with_inner(const std::vector<PlannedStage>& stages, std::size_t i) {
  double seconds = 0;
  for (std::size_t k = i; k < end_of(stages, i); ++k) seconds += stages[k].seconds;
  return seconds;
}

void print_table(const RunPlan& plan, bool all_stages) {
  std::size_t width = std::string("stage").size();
  for (const PlannedStage& stage : plan.stages) width = std::max(width, stage.place.path.size());
  const auto row = [&](const auto&... cells) {
    std::cout << fmt::format("{:<{}}  {:>12}  {:>8}  {:>9}  {:>9}  {:>8}\n", cells...);
  };
  row("stage", width, "size", "cells/px", "M cells", "memory", "seconds");
  const std::vector<bool> is_shown = shown(plan.stages);
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    const PlannedStage& stage = plan.stages[i];
    if (!all_stages && !is_shown[i]) continue;
    const Workload& load = stage.load;
    const std::string& kind = stage.place.kind;
    const bool has_cells = stage.same_as.empty() && kind != "preprocess" && kind != "filter" &&
                           kind != "consistency" && kind != "penalty";
    row(stage.place.path, width, fmt::format("{} x {}", load.size.width, load.size.height),
        has_cells ? fmt::format("{}{:.0f}", load.estimated ? "~" : "", load.cells_per_pixel) : "",
        has_cells ? fmt::format("{:.1f}", load.cells() / 1e6) : "", bytes_text(stage.memory),
        stage.same_as.empty() ? fmt::format("{:.2f}", seconds_with_inner(plan.stages, i))
                              : "  found by " + stage.same_as);
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
    std::cout << (options.size.empty()
                      ? "        ~ as far as a run on smaller images tells of these\n"
                      : "        ~ as in a generated scene; it depends on what the images show\n");
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
Workload load_of_size(const Options& options, const Pipeline& pipeline, int threads) {
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
  Workload load = Workload::dense(size, kColour, possible);
  load.threads = threads;
  return load;
}

/// A generated scene in place of one that is not there.
RunTrace trace_of_generated(const Pipeline& pipeline, int threads) {
  synthesis::Options options;
  options.size = {512, 384};
  options.disparities = {0, 64};
  synthesis::GeneratedScene scene = synthesis::generate(options);
  const auto range = DisparityRange::uniform(scene.pair.size(), scene.disparities);
  return RunTrace::of_whole(pipeline, {std::move(scene.pair), range, {}}, {.threads = threads});
}

RunPlan plan_of_size(const Options& options, const Pipeline& pipeline, int threads,
                     PlanRequest& request) {
  request.load = load_of_size(options, pipeline, threads);
  return plan_run(trace_of_generated(pipeline, threads), request);
}

RunPlan plan_of_scene(const SceneRequest& scene, const Pipeline& pipeline, int threads,
                      PlanRequest& request) {
  SceneInputs inputs = read_scene(scene, pipeline);
  show_notes(inputs);
  const MatchRequest match{std::move(inputs.scene.pair), inputs.range, {}};
  request = {.load = workload_of(match, threads), .truth = !inputs.scene.truth.disparity.empty()};
  return plan_run(RunTrace::of_reduced(pipeline, match, {.threads = threads}), request);
}

void refuse_options_of_pairs(const Options& options) {
  refuse_for_surfaces({{"--left", !options.images.left.empty(), "give --images"},
                       {"--size", !options.size.empty(), "give the images, or a scene in YAML"},
                       {"--disparities", !options.disparities.empty(), "heights bound the search"},
                       {"--range-maps", !options.range_maps.empty(), "heights bound the search"},
                       {"--stages", options.all_stages, "--json has all stages"}});
}

void refuse_options_of_surfaces(const Options& options) {
  if (options.satellites == SatelliteFiles{}) return;
  throw UsageError(options.pipeline +
                   ": matches one pair of images; --images and what belongs to them are for "
                   "pipelines of type surface, such as dsm_tmgm16");
}

int plan(const Options& options) {
  set_up_logging(options.log_level);
  const Registry registry = make_registry(options.plugins);
  const auto named = load_named(options.pipeline, registry, parse_overrides(options.assignments));
  if (!named) return kUsage;
  const Pipeline& pipeline = *named;
  const int threads = use_threads(options.threads);
  if (makes_surfaces(pipeline)) {
    refuse_options_of_pairs(options);
    return plan_surface(pipeline, registry, {options.scene, options.satellites, options.json},
                        threads);
  }
  refuse_options_of_surfaces(options);
  Progress progress;
  progress.begin("measuring the speed of this machine");
  PlanRequest request;
  const RunPlan planned = options.size.empty() ? plan_of_scene(scene_request(options, registry),
                                                               pipeline, threads, request)
                                               : plan_of_size(options, pipeline, threads, request);
  progress.end();
  if (options.json) {
    std::cout << to_json(planned, request);
  } else {
    print(options, planned, request);
  }
  return kOk;
}

void add_plan_options(Command command, Options& options) {
  add_pipeline(command, options);
  add_scene_or_images(command, options);
  auto range_maps = add_search(command, options);
  command.option("--size", options.size, "In place of a scene: the size of colour images, px")
      .type_name("WxH")
      .excludes(command.find("scene"))
      .excludes(command.find("--left"))
      .excludes(range_maps);
  add_matching(command, options);
  add_satellite_files(command, options.satellites);
  add_surroundings(command, options);
}

}  // namespace

void add_plan(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command = line.add("plan", "Predict the memory and the time of a run",
                             [options] { return plan(*options); });
  add_plan_options(command, *options);
  command.flag("--stages", options->all_stages, "Show every stage of every level and view");
  command.flag("--json", options->json, "For programs: all stages, as an object");
}

}  // namespace xgm::cli
