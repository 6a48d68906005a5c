// SPDX-License-Identifier: Apache-2.0
#include "run/run_options.hpp"

#include <CLI/CLI.hpp>

namespace xgm::cli {
namespace {

void add_depth(CLI::App& command, RunCommandOptions& options) {
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

void add_insights(CLI::App& command, RunCommandOptions& options) {
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
}

}  // namespace

void add_run_options(CLI::App& command, RunCommandOptions& options) {
  add_pipeline(command, options);
  add_scene_or_images(command, options);
  add_search(command, options);
  command
      .add_option("-o,--output", options.output,
                  "Folder for disparity.pfm, disparity.png, status.png and run.json; made if "
                  "missing")
      ->type_name("DIR")
      ->capture_default_str();
  add_matching(command, options);
  add_memory_limit_option(command, options.memory_limit);
  add_insights(command, options);
  add_truth(command, options);
  command.add_flag("--report", options.report,
                   "Also write DIR/report.html: one page, for any browser, without network, that "
                   "shows maps, values, levels, times and configuration");
  add_depth(command, options);
  add_surroundings(command, options);
}

}  // namespace xgm::cli
