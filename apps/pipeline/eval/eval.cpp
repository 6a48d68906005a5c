// SPDX-License-Identifier: Apache-2.0
// pipeline eval: how good is a disparity map?
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "eval/eval_options.hpp"
#include "eval/eval_table.hpp"
#include "terminal/console.hpp"
#include "xgm/base/error.hpp"
#include "xgm/evaluation/run_record.hpp"
#include "xgm/evaluation/truth_doubts.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm::cli {
namespace fs = std::filesystem;
namespace {

constexpr const char* kStandardOutput = "-";

/// The files that are compared, before any is opened.
struct Comparison {
  std::string map;
  std::string confidence;  ///< "" = none
  std::optional<SceneFiles> scene;
};

Comparison find_files(const EvalOptions& options) {
  Comparison files{options.map, options.confidence, {}};
  if (fs::is_directory(options.map)) {
    const fs::path folder = options.map;
    files.map = (folder / "disparity.pfm").string();
    if (!fs::is_regular_file(files.map)) {
      throw UsageError(options.map +
                       ": has no disparity.pfm; give the output folder of a run, or "
                       "the file to judge");
    }
    const fs::path confidence = folder / "confidence.pfm";
    if (files.confidence.empty() && fs::is_regular_file(confidence)) {
      files.confidence = confidence.string();
    }
  }
  if (options.scene.empty() && options.truth.empty()) {
    throw UsageError("nothing says what is true; add --truth FILE or a SCENE_DIR");
  }
  if (std::filesystem::is_regular_file(options.scene)) {
    throw UsageError(options.scene + ": a scene is a folder; give ground truth as --truth FILE");
  }
  if (!options.scene.empty()) {
    files.scene = find_scene(options.scene, make_registry(options.plugins), options.scene_name,
                             options.dataset);
    if (files.scene->truth.disparity.file.empty()) {
      throw UsageError(
          options.scene +
          ": has no truth ('pipeline scenes' tells what is missing); give one with --truth FILE");
    }
  }
  return files;
}

/// A run of one scene can be judged by the truth of another; that is hardly meant.
void warn_of_other_images(const EvalOptions& options, const SceneFiles& scene) {
  const fs::path record = fs::path(options.map) / "run.json";
  if (!fs::is_regular_file(record)) return;
  for (const InputFile& used : recorded_inputs(read_file(record.string()))) {
    const std::string file = used.role == "left"    ? scene.images.left
                             : used.role == "right" ? scene.images.right
                                                    : "";
    if (file.empty() || !why_unreadable(file).empty()) continue;
    const FileIdentity identity = identify_file(file);
    if (identity.bytes == used.identity.bytes && identity.fnv1a64 == used.identity.fnv1a64) {
      continue;
    }
    log_warning(options.map + " is a run of other images (" + used.file + ") than those of scene " +
                scene.name + " (" + file + "); is it judged by the right truth?");
    return;
  }
}

GroundTruth read_truth(const EvalOptions& options, const Comparison& files, cv::Size size) {
  if (files.scene) return load_truth(files.scene->truth, size);
  GroundTruth truth;
  truth.disparity = read_disparities(options.truth, options.truth_divisor);
  if (!options.mask.empty()) truth.non_occluded = read_mask(options.mask);
  if (!options.objects.empty()) truth.objects = read_mask(options.objects);
  return truth;
}

std::vector<InputFile> identify(const EvalOptions& options, const Comparison& files) {
  std::vector<InputFile> inputs{{"map", files.map, identify_file(files.map)}};
  TruthFiles truth;
  if (files.scene) {
    truth = files.scene->truth;
  } else {
    truth.disparity.file = options.truth;
    truth.non_occluded = options.mask;
    truth.objects = options.objects;
  }
  for (const InputFile& input : identify_truth(truth)) inputs.push_back(input);
  if (!files.confidence.empty()) {
    inputs.push_back({"confidence", files.confidence, identify_file(files.confidence)});
  }
  return inputs;
}

EvaluationReport judge(const EvalOptions& options) {
  EvaluationReport report;
  report.rules = parse_rules(options);
  const Comparison files = find_files(options);
  if (files.scene) warn_of_other_images(options, *files.scene);
  report.rules.clip =
      parse_clip(options.clip, files.scene ? files.scene->disparities : std::nullopt);
  const DisparityMap map = read_map(files.map, options.divisor);
  const bool is_clipped_by_scene = files.scene && options.clip == kNdisp;
  if (is_clipped_by_scene) require_disparities_of_size(*files.scene, map.size());
  const GroundTruth truth = read_truth(options, files, map.size());
  report.size = map.size();
  report.regions = evaluate_regions(map, truth, report.rules);
  if (!files.confidence.empty()) {
    report.confidence =
        sparsification_by_region(map, truth, read_disparities(files.confidence), report.rules);
  }
  report.inputs = identify(options, files);
  for (const std::string& doubt : truth_doubts(map, truth.disparity, {})) log_warning(doubt);
  return report;
}

void write(const std::string& file, const std::string& text) {
  if (file == kStandardOutput) {
    std::cout << text;
  } else if (!file.empty()) {
    write_file(file, text);
  }
}

int eval(const EvalOptions& options) {
  const bool json_only = options.json == kStandardOutput, csv_only = options.csv == kStandardOutput;
  if (json_only && csv_only) {
    throw UsageError("--json - and --csv - cannot share standard output; give one of them a file");
  }
  EvaluationReport report;
  try {
    report = judge(options);
  } catch (const Error& error) {
    throw UsageError(error.message());  // files that cannot be compared are the caller's mistake
  }
  write(options.json, to_json(report));
  write(options.csv, to_csv(report));
  if (!json_only && !csv_only) std::cout << table(report);
  return kOk;
}

}  // namespace

void add_eval(CommandLine& line) {
  auto options = std::make_shared<EvalOptions>();
  add_eval_options(line.add("eval", "Compare a disparity map with the truth",
                            [options] { return eval(*options); }),
                   *options);
}

}  // namespace xgm::cli
