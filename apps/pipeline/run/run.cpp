// SPDX-License-Identifier: Apache-2.0
// pipeline run: match a pair of images.
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "options/pixels.hpp"
#include "options/scene_request.hpp"
#include "options/values.hpp"
#include "run/run_options.hpp"
#include "run/run_surface.hpp"
#include "run/summary.hpp"
#include "terminal/console.hpp"
#include "terminal/observer.hpp"
#include "terminal/stop_on_signal.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/evaluation/recorded_run.hpp"
#include "xgm/evaluation/run_folder.hpp"
#include "xgm/pipeline/lookup.hpp"
#include "xgm/tiles/in_tiles.hpp"

namespace xgm::cli {
namespace {

KeepRequest keep_request(const RunCommandOptions& options, const Registry& registry) {
  const double bytes = parse_bytes(options.cache_size, "--cache-size");
  return {.resume = options.resume,
          .cache = options.cache,
          .cache_bytes = static_cast<std::uint64_t>(bytes),
          .plugin_files = plugin_files(registry),
          .asked = {{"--tiles", options.tiles}, {"--memory-limit", options.memory_limit}}};
}

/// What is left of a run that was interrupted.
std::string left_in(const std::string& folder) {
  const std::string kept = (std::filesystem::path(folder) / kUnfinishedFolder).string();
  std::error_code unusable;
  if (!std::filesystem::exists(kept, unusable)) return "nothing of this run is left in " + folder;
  return "the same command with --resume goes on from " + kept;
}

RecordRequest record_request(const RunCommandOptions& options) {
  return {.folder = options.output,
          .overrides = parse_overrides(options.assignments),
          .dump = options.dump,
          .report = options.report,
          .explained = parse_explain(options.explain),
          .depth = {options.cloud, options.depth}};
}

/// In tiles, if that is asked for, or if a limit may ask for it.
ChooseParts parts(const RunCommandOptions& options, const Pipeline& pipeline) {
  const std::string& text = options.tiles;
  const bool keeps_stages = !options.dump.empty() || !options.explain.empty();
  if (text.empty() && (options.memory_limit.empty() || keeps_stages)) return {};
  if (text.empty()) return tiles::in_tiles_if_needed(pipeline);
  if (keeps_stages) {
    throw UsageError(
        "--tiles: the results of stages are not kept; leave out --dump and --explain, or "
        "match a part of the images as a whole");
  }
  return tiles::in_tiles(pipeline, parse_tiles(text));
}

int run_checked(const Pipeline& pipeline, const SceneRequest& scene, const RecordRequest& request,
                const RunOptions& options, Progress& progress) {
  const RecordedRun result = record_scene(pipeline, scene, request, options);
  progress.end();
  print_summary(result, request);
  if (result.failure.empty()) return kOk;
  log_error(result.failure);
  return kFailed;
}

int run(const RunCommandOptions& options, const std::vector<std::string>& command_line) {
  set_up_logging(options.log_level);
  RecordRequest request = record_request(options);
  request.command_line = command_line;
  const Registry registry = make_registry(options.plugins);
  const auto pipeline = load_named(options.pipeline, registry, request.overrides);
  if (!pipeline) return kUsage;
  Progress progress;
  TerminalObserver observer(progress);
  request.tell = [&](const std::string& what) { progress.begin(what); };
  request.tell("reading the images");  // or making the sample pair
  limit_memory(available_memory());
  const StopOnSignal stop;
  const RunOptions run{
      .observer = &observer, .threads = use_threads(options.threads), .stop = stop.token()};
  try {
    if (is_surface(*pipeline, options)) {
      return run_surface(*pipeline, registry, options, keep_request(options, registry),
                         command_line, run, progress);
    }
    const SceneRequest scene = scene_request(options, registry);
    request.parts = parts(options, *pipeline);
    request.keep = keep_request(options, registry);
    request.inputs = files_beside_scene(registry, options.scene, options.dataset);
    return run_checked(*pipeline, scene, request, run, progress);
  } catch (const Cancelled&) {
    log_warning("interrupted; " + left_in(options.output));
    return kSignalled + Interruptible::signal();
  }
}

}  // namespace

void add_run(CommandLine& line) {
  auto options = std::make_shared<RunCommandOptions>();
  add_run_options(line.add("run", "Match a pair of images",
                           [options, &line] { return run(*options, line.arguments()); }),
                  *options);
}

}  // namespace xgm::cli
