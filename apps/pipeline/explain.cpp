// SPDX-License-Identifier: Apache-2.0
// pipeline explain: why does this pixel have the disparity it has, or none?
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

#include "common.hpp"
#include "console.hpp"
#include "explain_pixels.hpp"
#include "run_inputs.hpp"
#include "run_memory.hpp"
#include "run_observer.hpp"
#include "xgm/io/file.hpp"

namespace xgm::cli {
namespace {

struct Options : RunOptions {
  std::vector<std::string> place;  ///< [SCENE] X Y
  std::string json;                ///< file, or "-" for stdout
};

/// What --json asks for, and otherwise the text.
void print(const Options& options, const Explanation& explanation) {
  if (options.json == "-") {
    std::cout << to_json(explanation);
    return;
  }
  std::cout << to_text(explanation);
  if (!options.json.empty()) write_file(options.json, to_json(explanation));
}

int explain_checked(const Options& options, const Pipeline& pipeline, const Plan& plan,
                    const ExplainPixels& pixels) {
  Progress progress;
  progress.begin("reading the images");
  auto [scene, range] = read_inputs(options, plan);
  const auto explainer = make_explainer(pixels, scene);

  Dumper no_dumps({}, {});
  RunObserver observer(progress, no_dumps);
  observer.show_to(*explainer);
  const MatchRequest request{std::move(scene.pair), range, {}};
  guard_memory(
      pipeline, request,
      {.load = workload_of(request, threads_of(options)), .truth = !scene.truth.disparity.empty()},
      plan.memory_limit);
  set_opencv_threads(options.threads);
  progress.begin("matching");
  pipeline.run(request, {.observer = &observer, .threads = options.threads});
  progress.end();
  print(options, explainer->explanations().front());
  return kOk;
}

/// Takes [SCENE] X Y apart.
ExplainPixels take_place(Options& options) {
  auto& place = options.place;
  if (place.size() == 3) {
    if (!options.images.left.empty()) {
      throw UsageError("give a scene, or --left and --right, not both");
    }
    options.scene = place.front();
    place.erase(place.begin());
  }
  return {{parse_pixel(place[0], place[1])}, 0};
}

int explain(Options options) {
  set_up_logging(options.log_level);
  const ExplainPixels pixels = take_place(options);
  const Registry registry = make_registry(options.plugins);
  const auto named = load_named(options.pipeline, registry, parse_overrides(options.assignments));
  if (!named) return kUsage;
  return explain_checked(options, named->pipeline, make_plan(options, named->pipeline, registry),
                         pixels);
}

}  // namespace

void add_explain(CLI::App& app, Invocation& call) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("explain", "Say why one pixel has its disparity, or none, stage by stage");
  add_explain_options(*command, *options, options->place);
  command
      ->add_option("--json", options->json,
                   "Also write all of it, complete curves included, for programs; '-' for stdout, "
                   "in place of the text")
      ->type_name("FILE|-");
  command->callback([options, &call] { call.exit_code = explain(*options); });
}

}  // namespace xgm::cli
