// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_options.hpp"

#include "options/scene_options.hpp"
#include "options/thresholds.hpp"
#include "options/values.hpp"
#include "xgm/base/error.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::cli {
namespace {

void add_pipelines(Command command, BenchOptions& options) {
  command
      .option("--pipelines", options.pipelines,
              "Pipeline files or names of shipped ones, separated by commas; all: every "
              "shipped one")
      .type_name("PIPELINE,...")
      .comma_separated()
      .required();
}

void add_sweeps(Command command, BenchOptions& options) {
  command
      .option("--sweep", options.sweeps,
              "Run every pipeline with each of these values, for example "
              "matcher.scale=4,8; may be given again: all combinations")
      .type_name("PATH=VALUE,...")
      .one_value_each();
  command.flag("--fused", options.fused,
               "For pipelines of type surface: all images of a scene at once. Without it, every "
               "two of them by themselves");
}

void add_output(Command command, BenchOptions& options) {
  command
      .option("-o,--output", options.output,
              "Folder for bench.md, bench.csv, bench.json, bench.html and, in "
              "PIPELINE/SET/SCENE, the results of every run. What is done there already is not "
              "run again")
      .type_name("DIR")
      .show_default();
  auto submit = command
                    .option("--submit", options.submit,
                            "Also write what this benchmark wants uploaded, to DIR/submit")
                    .type_name("middlebury|eth3d|kitti")
                    .one_of({"middlebury", "eth3d", "kitti"});
  command
      .option("--method", options.method,
              "What the upload calls the pipeline; without it by its own name")
      .type_name("NAME")
      .needs(submit);
  add_plugin_options(command, options.plugins);
}

}  // namespace

void add_bench_data(Command command, BenchOptions& options) {
  command
      .option("--data", options.data,
              "Folders of scenes, or scenes, of any known data set (see 'pipeline list "
              "dataset'); for pipelines of type surface, satellite scenes with a scene.yaml")
      .type_name("DIR...")
      .required();
  add_dataset_option(command, options.dataset);
  command.option("--scenes", options.scenes, "Only these scenes, separated by commas")
      .type_name("NAME,...")
      .comma_separated();
  add_set_option(command, options.assignments);
  add_threads_option(command, options.threads, "Threads of each run; without it all processors");
  add_memory_limit_option(command, options.memory_limit);
}

void add_bench_rules(Command command, BenchOptions& options) {
  command
      .option("--scale", options.scale,
              "Multiply errors by it before they are judged: 4 judges maps of quarter "
              "resolution in px of the full one; full: what each scene's data set says")
      .type_name("NUMBER|full")
      .show_default();
  command.flag("--clip", options.rules.clip,
               "Move disparities into 0 to ndisp of the scene before they are judged, as "
               "Middlebury does");
  command
      .option("--region", options.rules.region,
              "Pixels that are judged. Without it: non-occluded, where a scene tells")
      .type_name("NAME")
      .one_of(
          {"all", "non-occluded", "occluded", "near discontinuities", "background", "foreground"});
}

void add_bench_options(Command command, BenchOptions& options) {
  add_pipelines(command, options);
  add_bench_data(command, options);
  add_sweeps(command, options);
  add_thresholds_option(command, options.thresholds);
  add_bench_rules(command, options);
  add_output(command, options);
}

std::vector<std::string> pipeline_names(const BenchOptions& options) {
  std::vector<std::string> names;
  for (const std::string& name : options.pipelines) {
    if (name != "all") {
      names.push_back(name);
      continue;
    }
    const auto shipped = shipped_pipelines();
    names.insert(names.end(), shipped.begin(), shipped.end());
  }
  return names;
}

BenchRules rules_of(const BenchOptions& options) {
  BenchRules rules = options.rules;
  rules.thresholds = parse_thresholds(options.thresholds);
  if (options.scale == "full") {
    rules.scale = 0;
    return rules;
  }
  const auto scale = parse_number(options.scale);
  if (!scale || *scale <= 0) {
    throw UsageError("--scale " + options.scale + ": give a number above 0, or full");
  }
  rules.scale = *scale;
  return rules;
}

}  // namespace xgm::cli
