// SPDX-License-Identifier: Apache-2.0
#include "run_options.hpp"

#include <CLI/CLI.hpp>

#include "xgm/base/parallel.hpp"

namespace xgm::cli {
namespace {

/// The check without its note in the help text, where the type says FILE already.
CLI::Validator existing_file() { return CLI::Validator(CLI::ExistingFile).description(""); }

void add_pipeline(CLI::App& command, RunOptions& options) {
  command
      .add_option("pipeline", options.pipeline,
                  "Pipeline file, or name of a shipped one (with or without .yaml)")
      ->type_name("PIPELINE")
      ->required();
}

CLI::Option* add_scene(CLI::App& command, RunOptions& options) {
  return command
      .add_option("scene", options.scene,
                  "Folder of a scene, or of scenes, of any known data set (see 'pipeline list "
                  "dataset'). With neither scene nor images the built-in sample pair is matched")
      ->type_name("SCENE_DIR");
}

/// Which of the scenes in the folder that `scene` takes, and how it is laid out.
void add_scene_choice(CLI::App& command, RunOptions& options, CLI::Option* scene) {
  command.add_option("--scene", options.scene_name, "Which scene, if SCENE_DIR holds several")
      ->type_name("NAME")
      ->needs(scene);
  add_dataset_option(command, options.dataset)->needs(scene);
}

/// Returns --left.
CLI::Option* add_images(CLI::App& command, RunOptions& options) {
  auto* left = command.add_option("--left", options.images.left, "Left (base) image");
  auto* right = command.add_option("--right", options.images.right, "Right (match) image");
  auto* left_mask = command.add_option("--left-mask", options.images.left_mask,
                                       "Image that is not zero where the left one may be used");
  auto* right_mask =
      command.add_option("--right-mask", options.images.right_mask, "The same for the right one");
  for (auto* option : {left, right, left_mask, right_mask}) {
    option->type_name("FILE")->check(existing_file());
  }
  left->needs(right);
  right->needs(left);
  return left;
}

CLI::Option* add_interval(CLI::App& command, RunOptions& options) {
  return command
      .add_option("--disparities", options.disparities,
                  "Smallest and largest disparity to search, both included, px: 0:63, -64:64. "
                  "Without it: what the data set says (ndisp of calib.txt), else "
                  "'disparities' of the pipeline")
      ->type_name("MIN:MAX");
}

/// Returns --range-maps.
CLI::Option* add_search(CLI::App& command, RunOptions& options) {
  auto* interval = add_interval(command, options);
  return command
      .add_option("--range-maps", options.range_maps,
                  "Smallest and largest disparity of every pixel, both included: two PFM files; "
                  "not finite = nothing to search")
      ->type_name("MIN.pfm,MAX.pfm")
      ->excludes(interval);
}

void add_matching(CLI::App& command, RunOptions& options) {
  add_set_option(command, options.assignments);
  constexpr int kMaxThreads = 1024;
  command.add_option("--threads", options.threads, "Threads to use; without it all processors")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxThreads));
}

void add_truth(CLI::App& command, RunOptions& options) {
  auto* truth = command
                    .add_option("--truth", options.truth,
                                "True disparities to compare with: PFM, or 8- or 16-bit PNG with "
                                "--truth-divisor (0 = none). Without it those of the scene, if it "
                                "has any")
                    ->type_name("FILE")
                    ->check(existing_file());
  command
      .add_option("--truth-divisor,--truth-scale", options.truth_divisor,
                  "What the truth's values are divided by to give px (KITTI: 256)")
      ->type_name("NUMBER")
      ->needs(truth);
  command
      .add_option("--truth-mask", options.truth_mask,
                  "Image that is 255 where the map is judged (Middlebury: mask0nocc.png)")
      ->type_name("FILE")
      ->check(existing_file())
      ->needs(truth);
}

void add_depth(CLI::App& command, RunOptions& options) {
  command
      .add_option("--cloud", options.cloud,
                  "Also write the points, coloured, in mm (binary PLY), and their depths; the "
                  "scene's calibration must be known")
      ->type_name("FILE.ply");
  command
      .add_option("--depth", options.depth,
                  "Also write the depths in mm (float TIFF, NaN = none); with --cloud NAME.ply "
                  "this is NAME_depth.tiff unless given")
      ->type_name("FILE.tiff");
}

void add_surroundings(CLI::App& command, RunOptions& options) {
  add_plugin_options(command, options.plugins);
  command
      .add_option("--log-level", options.log_level,
                  "debug, info, warning or error; progress is shown down to info")
      ->type_name("L")
      ->check(CLI::IsMember({"debug", "info", "warning", "error"}))
      ->capture_default_str();
}

}  // namespace

void add_run_options(CLI::App& command, RunOptions& options) {
  add_pipeline(command, options);
  auto* scene = add_scene(command, options);
  add_scene_choice(command, options, scene);
  add_images(command, options)->excludes(scene);
  add_search(command, options);
  command
      .add_option("-o,--output", options.output,
                  "Folder for disparity.pfm, disparity.png, status.png and run.json; made if "
                  "missing")
      ->type_name("DIR")
      ->capture_default_str();
  add_matching(command, options);
  add_memory_limit_option(command, options.memory_limit);
  command
      .add_option("--dump", options.dump,
                  "Also write the result of every stage whose path matches (see run.json for the "
                  "paths), to DIR/dump: '*' for all, '*.cost'")
      ->type_name("GLOB");
  command
      .add_option(
          "--explain", options.explain,
          "Also keep why this pixel, or every N-th of the image, has its disparity or none, "
          "in DIR/explain.json; may be given again")
      ->type_name("X,Y|every=N")
      ->allow_extra_args(false);
  add_truth(command, options);
  command.add_flag("--report", options.report,
                   "Also write DIR/report.html: one page, for any browser, without network, that "
                   "shows maps, values, levels, times and configuration");
  add_depth(command, options);
  add_surroundings(command, options);
}

void add_explain_options(CLI::App& command, RunOptions& options, std::vector<std::string>& place) {
  add_pipeline(command, options);
  auto* pixel =
      command
          .add_option(
              "pixel", place,
              "Column and row of the pixel in the left image, from 0 on; before them the scene's "
              "folder, unless images are given or the built-in sample pair is meant")
          ->type_name("[SCENE_DIR] X Y")
          ->expected(2, 3)
          ->required();
  add_scene_choice(command, options, pixel);
  add_images(command, options);
  add_search(command, options);
  add_matching(command, options);
  add_memory_limit_option(command, options.memory_limit);
  add_truth(command, options);
  add_surroundings(command, options);
}

void add_plan_options(CLI::App& command, RunOptions& options, std::string& size) {
  add_pipeline(command, options);
  auto* scene = add_scene(command, options);
  add_scene_choice(command, options, scene);
  auto* images = add_images(command, options)->excludes(scene);
  auto* range_maps = add_search(command, options);
  command.add_option("--size", size, "In place of a scene: the size of colour images, px")
      ->type_name("WxH")
      ->excludes(scene)
      ->excludes(images)
      ->excludes(range_maps);
  add_matching(command, options);
  add_surroundings(command, options);
}

void add_speed_options(CLI::App& command, RunOptions& options) {
  command
      .add_option("pipelines", options.pipeline,
                  "Pipeline files or names of shipped ones, separated by commas")
      ->type_name("PIPELINE,...")
      ->required();
  auto* scene = add_scene(command, options);
  add_scene_choice(command, options, scene);
  add_images(command, options)->excludes(scene);
  add_interval(command, options);
  add_matching(command, options);
  add_surroundings(command, options);
}

int threads_of(const RunOptions& options) {
  return options.threads > 0 ? options.threads : thread_count();
}

std::pair<std::string, std::string> parse_range_maps(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || comma == 0 || comma + 1 == text.size() ||
      text.find(',', comma + 1) != std::string::npos) {
    throw UsageError("--range-maps " + text + ": write two file names, MIN.pfm,MAX.pfm");
  }
  const std::pair files(text.substr(0, comma), text.substr(comma + 1));
  for (const std::string& file : {files.first, files.second}) {
    const std::string problem = CLI::ExistingFile(file);
    if (!problem.empty()) throw UsageError("--range-maps: " + problem);
  }
  return files;
}

}  // namespace xgm::cli
