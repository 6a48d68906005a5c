// SPDX-License-Identifier: Apache-2.0
// pipeline speed: how fast are pipelines, beside each other and OpenCV?
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/output_files.hpp"
#include "options/scene_request.hpp"
#include "options/surfaces.hpp"
#include "options/values.hpp"
#include "terminal/observer.hpp"
#include "xgm/base/simd.hpp"
#include "xgm/evaluation/speed.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::cli {
namespace {

struct Options : SceneOptions {
  std::vector<std::string> simd;
  std::vector<std::string> opencv;
  int repeat = 5;
  std::string json;  ///< file, or "-" for stdout
};

/// "all" stands for everything there is, "none" alone for nothing; each is named once.
std::vector<std::string> choose(const std::string& what, const std::vector<std::string>& wanted,
                                const std::vector<std::string>& known) {
  std::vector<std::string> chosen;
  for (const std::string& name : wanted) {
    if (name == "all") return known;
    if (name == "none" && wanted.size() == 1) return {};
    require_name(what, name, known);
    if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
  }
  return chosen;
}

SpeedRace make_speed_plan(const Options& options) {
  SpeedRace race;
  race.threads = use_threads(options.threads);
  race.rounds = options.repeat;
  race.peers = choose("StereoSGBM mode", options.opencv, opencv_modes());
  race.simd = choose("SIMD target", options.simd, simd_targets());
  if (race.simd.empty()) race.simd.push_back(simd_target());
  return race;
}

/// Empty if anything is wrong, all of which has been said.
std::vector<SpeedPipeline> load_pipelines(const Options& options, const Registry& registry) {
  std::vector<SpeedPipeline> pipelines;
  bool sound = true;
  for (const std::string& name : split_at_commas(options.pipeline)) {
    const auto pipeline = load_named(name, registry, parse_overrides(options.assignments));
    sound = sound && pipeline;
    if (pipeline) {
      require_pair_pipeline(*pipeline, "speed",
                            "time the one that it names as 'matching', or see 'pipeline bench'");
      pipelines.push_back({std::filesystem::path(pipeline->file()).stem().string(), *pipeline});
    }
  }
  return sound ? pipelines : std::vector<SpeedPipeline>{};
}

void print(const Options& options, const SpeedResult& result) {
  if (options.json != kStandardOutput) std::cout << speed_markdown(result);
  write_output(options.json, speed_json(result));
}

int speed(const Options& options) {
  SpeedRace race = make_speed_plan(options);
  const Registry registry = make_registry(options.plugins);
  race.pipelines = load_pipelines(options, registry);
  if (race.pipelines.empty()) return kUsage;
  const SceneRequest scene = scene_request(options, registry);
  std::vector<Pipeline> pipelines;
  for (const SpeedPipeline& each : race.pipelines) pipelines.push_back(each.pipeline);
  const NamedFile json{"--json", options.json};
  require_outputs_apart(files_read(options, scene, pipelines, registry), {json});
  require_writable_output(json);
  Progress progress;
  progress.begin("reading the images");
  SceneInputs inputs = read_scene(scene, race.pipelines.front().pipeline);
  show_notes(inputs);
  const MatchRequest request{std::move(inputs.scene.pair), inputs.range, {}};
  const SpeedResult result =
      time_pipelines(race, request, [&](const std::string& what) { progress.begin(what); });
  progress.end();
  print(options, result);
  return kOk;
}

void add_speed_options(Command command, Options& options) {
  command
      .option("pipelines", options.pipeline,
              "Pipeline files or names of shipped ones, separated by commas")
      .type_name("PIPELINE,...")
      .required();
  add_scene_or_images(command, options);
  add_interval(command, options);
  add_matching(command, options);
  add_surroundings(command, options);
}

void add_race_options(Command command, Options& options) {
  command
      .option("--repeat", options.repeat,
              "Rounds; in each everything runs once, and medians are told")
      .type_name("N")
      .range(1, 1000)
      .show_default();
  command
      .option("--simd", options.simd,
              "Run the pipelines with each of these SIMD targets; all: those of this "
              "processor. Without it the best one, or that of XGM_SIMD")
      .type_name("TARGET,...")
      .comma_separated();
  command
      .option("--opencv", options.opencv,
              "Modes of cv::StereoSGBM to compare with: hh, hh4, sgbm, sgbm_3way, all, none")
      .type_name("MODE,...")
      .comma_separated()
      .show_default("all");
  command
      .option("--json", options.json,
              "Also write every round, for programs; '-' for stdout, in place of the tables")
      .type_name("FILE|-");
}

}  // namespace

void add_speed(CommandLine& line) {
  auto options = std::make_shared<Options>();
  options->opencv = {"all"};
  Command command =
      line.add("speed", "Time pipelines, stage by stage, and OpenCV's StereoSGBM on the same pair",
               [options] { return speed(*options); });
  add_speed_options(command, *options);
  add_race_options(command, *options);
}

}  // namespace xgm::cli
