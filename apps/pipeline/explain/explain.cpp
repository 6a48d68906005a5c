// SPDX-License-Identifier: Apache-2.0
// pipeline explain: why does this pixel have the disparity it has, or none?

#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/output_files.hpp"
#include "options/pixels.hpp"
#include "options/scene_request.hpp"
#include "options/surfaces.hpp"
#include "terminal/console.hpp"
#include "terminal/observer.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/pipeline/scene_run.hpp"
#include "xgm/stage/observers.hpp"

namespace xgm::cli {
namespace {

struct Options : SceneOptions {
  std::vector<std::string> place;  ///< [SCENE] X Y
  std::string json;                ///< file, or "-" for stdout
};

/// What --json asks for, and the text unless it takes its place.
void print(const Options& options, const Explanation& explanation) {
  if (options.json != kStandardOutput) std::cout << to_text(explanation);
  write_output(options.json, to_json(explanation));
}

int explain_checked(const Options& options, const Pipeline& pipeline, const Registry& registry,
                    const ExplainPixels& pixels) {
  const SceneRequest request = scene_request(options, registry);
  const NamedFile json{"--json", options.json};
  require_outputs_apart(files_read(options, request, {pipeline}, registry), {json});
  require_writable_output(json);
  Progress progress;
  progress.begin("reading the images");
  limit_memory(available_memory());
  SceneInputs inputs = read_scene(request, pipeline);
  const auto explainer = make_explainer(pixels, inputs.scene);
  TerminalObserver terminal(progress);
  Observers observers;
  observers.add(terminal);
  observers.add(*explainer);
  progress.begin("matching");
  match_scene(pipeline, std::move(inputs),
              {.observer = &observers, .threads = use_threads(options.threads)});
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
  const auto pipeline =
      load_named(options.pipeline, registry, parse_overrides(options.assignments));
  if (!pipeline) return kUsage;
  require_pair_pipeline(*pipeline, "explain",
                        "reasons.tif of 'pipeline run' says why cells are empty");
  return explain_checked(options, *pipeline, registry, pixels);
}

void add_explain_options(Command command, Options& options) {
  add_pipeline(command, options);
  auto pixel =
      command
          .option(
              "pixel", options.place,
              "Column and row of the pixel in the left image, from 0 on; before them the scene's "
              "folder, unless images are given or the built-in sample pair is meant")
          .type_name("[SCENE_DIR] X Y")
          .count(2, 3)
          .required();
  add_scene_choice(command, options, pixel);
  add_images(command, options);
  add_search(command, options);
  add_matching(command, options);
  add_memory_limit_option(command, options.memory_limit);
  add_truth(command, options);
  add_surroundings(command, options);
}

}  // namespace

void add_explain(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command =
      line.add("explain", "Say why one pixel has its disparity, or none, stage by stage",
               [options] { return explain(*options); });
  add_explain_options(command, *options);
  command
      .option("--json", options->json,
              "Also write all of it, complete curves included, for programs; '-' for stdout, "
              "in place of the text")
      .type_name("FILE|-");
}

}  // namespace xgm::cli
