// SPDX-License-Identifier: Apache-2.0
// pipeline run: match a pair of images.
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "commands.hpp"
#include "options/pixels.hpp"
#include "options/scene_request.hpp"
#include "run/run_options.hpp"
#include "run/summary.hpp"
#include "terminal/console.hpp"
#include "terminal/observer.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/evaluation/recorded_run.hpp"

namespace xgm::cli {
namespace {

int run_checked(const Pipeline& pipeline, const SceneRequest& scene, RecordRequest request,
                int threads) {
  Progress progress;
  TerminalObserver observer(progress);
  request.tell = [&](const std::string& what) { progress.begin(what); };
  limit_memory(available_memory());
  const RecordedRun result =
      record_scene(pipeline, scene, request, {.observer = &observer, .threads = threads});
  progress.end();
  print_summary(result, request);
  if (result.failure.empty()) return kOk;
  spdlog::error(result.failure);
  return kFailed;
}

int run(const RunCommandOptions& options, const std::vector<std::string>& command_line) {
  set_up_logging(options.log_level);
  const std::vector<Override> overrides = parse_overrides(options.assignments);
  const Registry registry = make_registry(options.plugins);
  const auto pipeline = load_named(options.pipeline, registry, overrides);
  if (!pipeline) return kUsage;
  const SceneRequest scene = scene_request(options, registry);
  return run_checked(*pipeline, scene,
                     {.folder = options.output,
                      .overrides = overrides,
                      .command_line = command_line,
                      .dump = options.dump,
                      .report = options.report,
                      .explained = parse_explain(options.explain),
                      .depth = {options.cloud, options.depth}},
                     use_threads(options.threads));
}

}  // namespace

void add_run(CLI::App& app, Invocation& call) {
  auto options = std::make_shared<RunCommandOptions>();
  CLI::App* command = app.add_subcommand("run", "Match a pair of images");
  add_run_options(*command, *options);
  command->callback([options, &call] { call.exit_code = run(*options, call.arguments); });
}

}  // namespace xgm::cli
