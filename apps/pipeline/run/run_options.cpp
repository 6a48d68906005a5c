// SPDX-License-Identifier: Apache-2.0
#include "run/run_options.hpp"

namespace xgm::cli {
namespace {

void add_depth(Command command, RunCommandOptions& options) {
  command
      .option("--cloud", options.cloud,
              "Also write the points, coloured, in mm (binary PLY), and their depths; the "
              "scene's calibration must be known")
      .type_name("FILE.ply");
  command
      .option("--depth", options.depth,
              "Also write the depths in mm (float TIFF, NaN = none); with --cloud NAME.ply "
              "this is NAME_depth.tiff unless given")
      .type_name("FILE.tiff");
}

void add_keeping(Command command, RunCommandOptions& options) {
  auto resume = command.flag(
      "--resume", options.resume,
      "Go on from what a run of the same command that did not end has left in DIR/unfinished.xgm, "
      "which is kept more completely if this is given from the beginning");
  auto cache =
      command
          .option("--cache", options.cache,
                  "Keep what is matched in this folder, for any run that matches the same: "
                  "only what comes after is then done. May be shared by many runs")
          .type_name("DIR")
          .excludes(resume);
  command
      .option("--cache-size", options.cache_size,
              "What the folder may hold; what was not used for the longest time is removed")
      .type_name("SIZE")
      .needs(cache)
      .show_default();
}

void add_insights(Command command, RunCommandOptions& options) {
  command
      .option("--dump", options.dump,
              "Also write the result of every stage whose path matches (see run.json for the "
              "paths), to DIR/dump: '*' for all, '*.cost'")
      .type_name("GLOB");
  command
      .option("--explain", options.explain,
              "Also keep why this pixel, or every N-th of the image, has its disparity or none, "
              "in DIR/explain.json; may be given again")
      .type_name("X,Y|every=N")
      .one_value_each();
}

void add_surface(Command command, RunCommandOptions& options) {
  add_satellite_files(command, options.satellites);
  command
      .option("--geoid", options.geoid,
              "Heights of the surface are above this geoid: egm96, or another one whose grid PROJ "
              "has; without it above the ellipsoid")
      .type_name("NAME")
      .value_of_name_alone("egm96");
  command
      .option("--clouds", options.clouds,
              "In place of images: clouds of earlier runs (DIR/cloud.ply), which are made a "
              "surface of again without matching")
      .type_name("FILE.ply...")
      .existing_file()
      .excludes(command.find("--images"));
}

}  // namespace

void add_run_options(Command command, RunCommandOptions& options) {
  add_pipeline(command, options);
  add_scene_or_images(command, options);
  add_search(command, options);
  command
      .option("-o,--output", options.output,
              "Folder for disparity.pfm, disparity.png, status.png and run.json; made if "
              "missing")
      .type_name("DIR")
      .show_default();
  add_matching(command, options);
  add_memory_limit_option(command, options.memory_limit);
  command
      .option("--tiles", options.tiles,
              "Match in tiles, which bounds the memory: of this size in px, or of one that fits "
              "--memory-limit, else what is free. With --memory-limit alone: if the whole does not "
              "fit")
      .type_name("auto|WIDTHxHEIGHT");
  add_keeping(command, options);
  add_insights(command, options);
  add_truth(command, options);
  command.flag("--report", options.report,
               "Also write DIR/report.html: one page, for any browser, without network, that "
               "shows maps, values, levels, times and configuration");
  add_depth(command, options);
  add_surface(command, options);
  add_surroundings(command, options);
}

}  // namespace xgm::cli
