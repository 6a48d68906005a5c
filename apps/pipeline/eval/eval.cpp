// SPDX-License-Identifier: Apache-2.0
// pipeline eval: how good is a disparity map?
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "eval/eval_options.hpp"
#include "eval/eval_surface.hpp"
#include "eval/eval_table.hpp"
#include "options/output_files.hpp"
#include "options/scene_request.hpp"
#include "options/values.hpp"
#include "terminal/console.hpp"
#include "xgm/base/error.hpp"
#include "xgm/evaluation/run_record.hpp"
#include "xgm/evaluation/truth_doubts.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/image_io.hpp"

namespace xgm::cli {
namespace fs = std::filesystem;
namespace {

/// The files that are compared, before any is opened.
struct Comparison {
  std::string map;
  std::string confidence;  ///< "" = none
  std::optional<SceneFiles> scene;
  std::vector<NamedFile> read_for_scene;  ///< beside its own files
};

Comparison find_files(const EvalOptions& options) {
  Comparison files{options.map, options.confidence, {}, {}};
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
    const Registry registry = make_registry(options.plugins);
    files.scene = find_scene(options.scene, registry, options.scene_name, options.dataset);
    files.read_for_scene = files_beside_scene(registry, options.scene, options.dataset);
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

/// The value, after a word on what is doubtful in its file.
template <class Value>
Value warned(Noted<Value> read) {
  for (const std::string& warning : read.warnings) log_warning(warning);
  return std::move(read.value);
}

GroundTruth read_truth(const EvalOptions& options, const Comparison& files, cv::Size size) {
  if (files.scene) {
    GroundTruth truth = load_truth(files.scene->truth, size);
    for (const std::string& warning : truth.warnings) log_warning(warning);
    return truth;
  }
  GroundTruth truth;
  truth.disparity =
      warned(read_disparities(options.truth, options.truth_divisor,
                              parse_no_data(options.truth_no_data, "--truth-nodata")));
  if (!options.mask.empty()) truth.non_occluded = warned(read_mask(options.mask, MaskUse::judged));
  if (!options.objects.empty())
    truth.objects = warned(read_mask(options.objects, MaskUse::objects));
  return truth;
}

/// The files that are compared, and their roles.
std::vector<NamedFile> compared(const EvalOptions& options, const Comparison& files) {
  std::vector<NamedFile> inputs{{"map", files.map}};
  const TruthFiles truth = files.scene ? files.scene->truth
                                       : TruthFiles{.disparity = {options.truth},
                                                    .non_occluded = options.mask,
                                                    .objects = options.objects};
  for (NamedFile& input : files_of(truth)) inputs.push_back(std::move(input));
  if (!files.confidence.empty()) inputs.push_back({"confidence", files.confidence});
  return inputs;
}

void require_outputs(const EvalOptions& options, const Comparison& files) {
  std::vector<NamedFile> inputs = compared(options, files);
  inputs.push_back({"record", (fs::path(options.map) / "run.json").string()});
  inputs.insert(inputs.end(), files.read_for_scene.begin(), files.read_for_scene.end());
  if (files.scene) {
    for (NamedFile& input : files_of(*files.scene)) inputs.push_back(std::move(input));
  }
  require_outputs_apart(inputs, {{"--json", options.json}, {"--csv", options.csv}});
}

EvaluationReport judge(const EvalOptions& options) {
  EvaluationReport report;
  report.rules = parse_rules(options);
  const Comparison files = find_files(options);
  require_outputs(options, files);
  if (files.scene) warn_of_other_images(options, *files.scene);
  report.rules.clip =
      parse_clip(options.clip, files.scene ? files.scene->disparities : std::nullopt);
  const DisparityMap map =
      warned(read_map(files.map, options.divisor, parse_no_data(options.no_data, "--nodata")));
  const bool is_clipped_by_scene = files.scene && options.clip == kNdisp;
  if (is_clipped_by_scene) require_disparities_of_size(*files.scene, map.size());
  const GroundTruth truth = read_truth(options, files, map.size());
  report.size = map.size();
  report.regions = evaluate_regions(map, truth, report.rules);
  if (!files.confidence.empty()) {
    report.confidence = sparsification_by_region(
        map, truth, warned(read_disparities(files.confidence)), report.rules);
  }
  report.inputs = identify_files(compared(options, files));
  for (const std::string& doubt : truth_doubts(map, truth.disparity, {})) log_warning(doubt);
  return report;
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
  write_output(options.json, to_json(report));
  write_output(options.csv, to_csv(report));
  if (!json_only && !csv_only) std::cout << table(report);
  return kOk;
}

}  // namespace

void add_eval(CommandLine& line) {
  auto options = std::make_shared<EvalOptions>();
  add_eval_options(
      line.add("eval", "Compare a disparity map with the truth",
               [options] { return options->surface ? eval_surface(*options) : eval(*options); }),
      *options);
}

}  // namespace xgm::cli
