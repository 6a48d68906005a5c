// SPDX-License-Identifier: Apache-2.0
#include "eval/eval_options.hpp"

#include <cmath>

#include "options/scene_options.hpp"
#include "options/thresholds.hpp"
#include "options/values.hpp"
#include "xgm/base/error.hpp"

namespace xgm::cli {
namespace {

void add_inputs(Command command, EvalOptions& options) {
  command
      .option("map", options.map,
              "Disparities to judge: PFM, PNG with --divisor, or the output folder of "
              "'pipeline run'")
      .type_name("DISPARITY|OUTPUT_DIR")
      .existing_path()
      .required();
  auto scene =
      command.option("scene", options.scene, "Folder of the scene: its truth, mask and ndisp")
          .type_name("SCENE_DIR")
          .existing_path();
  command.option("--scene", options.scene_name, "Which scene, if SCENE_DIR holds several")
      .type_name("NAME")
      .needs(scene);
  add_dataset_option(command, options.dataset).needs(scene);
  add_plugin_options(command, options.plugins);
  command
      .option("--divisor", options.divisor,
              "What values of DISPARITY are divided by to give px (KITTI: 256); without it "
              "only float files are taken for disparities")
      .type_name("NUMBER");
  add_no_data_option(command, "--nodata", options.no_data, "DISPARITY");
  auto truth = command.option("--truth", options.truth,
                              "True disparities: PFM, or PNG with --truth-divisor");
  truth.type_name("FILE").existing_file().excludes(scene);
  command
      .option("--truth-divisor,--truth-scale", options.truth_divisor,
              "The same for the truth (negative: a map of the right view, stored as positive "
              "numbers)")
      .type_name("NUMBER")
      .needs(truth);
  add_no_data_option(command, "--truth-nodata", options.truth_no_data, "the truth").needs(truth);
  auto mask = command.option("--mask,--truth-mask", options.mask,
                             "Image that is 255 on non-occluded pixels (mask0nocc.png)");
  auto objects =
      command.option("--objects", options.objects, "Object map, 0 = background (KITTI: obj_map)");
  for (Option option : {mask, objects}) {
    option.type_name("FILE").existing_file().needs(truth);
  }
  command
      .option("--confidence", options.confidence,
              "Float image, larger = surer: judged by sparsification. Without it "
              "confidence.pfm of OUTPUT_DIR, if there is one")
      .type_name("FILE")
      .existing_file();
}

void add_rules(Command command, EvalOptions& options) {
  add_thresholds_option(command, options.thresholds);
  command
      .option("--scale", options.scale,
              "Multiplies errors: 4 judges maps of quarter resolution in px of full resolution")
      .type_name("NUMBER")
      .show_default("1");
  command
      .option("--clip", options.clip,
              "Move disparities outside to its ends first, both included, px; 'ndisp': 0 to "
              "ndisp of the scene, as Middlebury's evaluation does")
      .type_name("MIN:MAX|ndisp");
}

}  // namespace

void add_eval_options(Command command, EvalOptions& options) {
  command.flag(
      "--surface", options.surface,
      "Compare heights (m): a surface of satellite images with --truth, LiDAR for example");
  command
      .option("--source", options.source,
              "With --surface: source.tif of the run, for figures without the heights that a "
              "filter has filled. Without it that of OUTPUT_DIR")
      .type_name("FILE")
      .existing_file();
  add_inputs(command, options);
  add_rules(command, options);
  command
      .option("--json", options.json,
              "Write all figures as JSON; - is standard output, which "
              "then holds nothing else")
      .type_name("FILE|-");
  command.option("--csv", options.csv, "The same as CSV, a line per region").type_name("FILE|-");
}

EvaluationRules parse_rules(const EvalOptions& options) {
  if (!std::isfinite(options.scale) || options.scale <= 0) {
    throw UsageError("--scale: must be a number above 0");
  }
  return {.deltas = parse_thresholds(options.thresholds), .scale = options.scale};
}

Interval parse_clip(const std::string& text, const std::optional<Interval>& bound) {
  if (text.empty()) return {};
  if (text != kNdisp) return parse_disparities(text, "--clip");
  if (!bound) {
    throw UsageError("--clip ndisp: nothing gives the scene's ndisp; write --clip MIN:MAX");
  }
  return benchmark_clip(*bound);
}

}  // namespace xgm::cli
