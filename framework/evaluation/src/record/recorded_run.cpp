// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/recorded_run.hpp"

#include <filesystem>
#include <memory>

#include "record/doubts.hpp"
#include "record/kept_map.hpp"
#include "record/scene_keeping.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/evaluation/report.hpp"
#include "xgm/evaluation/run_folder.hpp"
#include "xgm/evaluation/truth_doubts.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/write_maps.hpp"
#include "xgm/stage/observers.hpp"

namespace xgm {
namespace {
namespace fs = std::filesystem;

/// The files that a run will write; only dumps are not known before.
std::vector<NamedFile> planned_files(const RecordRequest& request, const DepthFiles& depth) {
  std::vector<NamedFile> files{{"--cloud", depth.cloud}, {"--depth", depth.depth}};
  const auto add = [&](const char* name) {
    files.push_back({"--output", (fs::path(request.folder) / name).string()});
  };
  for (const char* name : kMapFiles) add(name);
  if (request.report) add(kReportFile);
  if (!request.explained.empty()) add(kExplanationsFile);
  add(kRecordFile);
  return files;
}

std::vector<NamedFile> files_read(const Pipeline& pipeline, const SceneRequest& scene,
                                  const RecordRequest& request) {
  std::vector<NamedFile> files = files_of(scene);
  files.push_back({"pipeline", pipeline.file()});
  files.insert(files.end(), request.inputs.begin(), request.inputs.end());
  return files;
}

/// All who watch the run for its record.
class Watchers {
 public:
  /// `folder` is null if nothing is to be written.
  Watchers(const RecordRequest& request, const Scene& scene, RunFolder* folder, Observer* callers)
      : dumper(folder != nullptr ? folder->file(kDumpFolder) : "", request.dump,
               [folder](const std::string& file) { folder->announce(file); }) {
    // A stage is recorded before the caller hears of it, and a dump that fails ends the run.
    all.add(recorder);
    if (callers != nullptr) all.add(*callers);
    if (!request.dump.empty()) all.add(dumper);
    if (request.report) all.add(levels);
    if (request.explained.empty()) return;
    explainer = make_explainer(request.explained, scene);
    all.add(*explainer);
  }

  RunRecorder recorder;
  Dumper dumper;
  LevelCollector levels;
  std::unique_ptr<Explainer> explainer;
  Observers all;
};

void add_bytes_of_report(SceneInputs& inputs) {
  inputs.besides.level_pixel = LevelCollector::kBytesPerPixel;
  inputs.besides.after += bytes_to_report(inputs.scene.size());
}

/// What cannot be had without all of the images and the map.
bool needs_whole(const RecordRequest& request, const SceneRequest& scene) {
  return request.holds_maps || request.report || !request.explained.empty() ||
         !request.dump.empty() || !request.depth.empty() || scene.truth ||
         !std::holds_alternative<SceneFiles>(scene.scene);
}

/// Whether the images, the map and the truth can be held beside what is matched. Runs that fit as a
/// whole take more than that of each pixel.
bool is_small(const SceneInputs& inputs) {
  constexpr double kBytes = 60;
  return !inputs.memory_limit || kBytes * inputs.scene.size().area() <= *inputs.memory_limit;
}

/// By windows if it is to be asked for parts; a truth of the scene is a reason to hold small ones.
SceneInputs read_inputs(const Pipeline& pipeline, const SceneRequest& scene,
                        const RecordRequest& request) {
  if (!request.parts || needs_whole(request, scene)) return read_scene(scene, pipeline);
  SceneRequest in_windows = scene;
  in_windows.scratch = request.folder;
  SceneInputs inputs = read_scene(in_windows, pipeline);
  const bool has_truth = !files_of(std::get<SceneFiles>(scene.scene).truth).empty();
  return has_truth && is_small(inputs) ? read_scene(scene, pipeline) : inputs;
}

void describe_run(RunRecord& record, const SceneRun& run, const Watchers& watchers) {
  record.scene = run.scene.name;
  record.inputs = run.scene.inputs;
  record.size = run.scene.size();
  record.disparities = run.disparities;
  record.disparities_from = run.disparities_from;
  record.reading_seconds = run.reading_seconds;
  record.matching_seconds = run.matching_seconds;
  record.stages = watchers.recorder.stages();
  record.warnings = run.warnings;
  record.dumps = watchers.dumper.files();
}

void describe_map(RunRecord& record, const SceneRun& run, const MapSummary& summary) {
  const DisparityMap& map = run.maps.forward;
  record.valid_share = summary.density();
  record.status_shares = summary.status_shares();
  if (!run.scene.truth.disparity.empty()) {
    record.truth = evaluate_regions(map, run.scene.truth, {.deltas = usual_thresholds()});
  }
}

std::string failure_of(const RunRecord& record) {
  if (record.valid_share > 0) return {};
  return "the map is empty: no pixel has a disparity; see status.png for the reasons, and check "
         "the "
         "order of the images and the disparity range (" +
         std::to_string(record.disparities.begin) + " to " +
         std::to_string(record.disparities.end - 1) + ")";
}

/// What is told of the run beside what its stages said.
void add_warnings(RecordedRun& result, const MapSummary& summary, const RecordRequest& request,
                  Observer* observer) {
  std::vector<std::string> warnings;
  if (!request.dump.empty() && result.record.dumps.empty()) {
    warnings.push_back("--dump " + request.dump +
                       ": no stage has such a path; run.json lists the paths");
  }
  if (result.failure.empty()) {
    const DisparityMap& map = result.run.maps.forward;
    for (const auto& found :
         {doubts(summary, result.record),
          truth_doubts(map, result.run.scene.truth.disparity, result.record.disparities)}) {
      warnings.insert(warnings.end(), found.begin(), found.end());
    }
  }
  for (const std::string& warning : warnings) {
    if (observer != nullptr) observer->log(LogLevel::warning, {}, warning);
    result.record.warnings.push_back(warning);
  }
}

void write_report(const std::string& file, const RecordedRun& result, const Watchers& watchers,
                  const std::string& explanations) {
  const fs::path path(result.record.scene);
  const std::string scene = (path.has_filename() ? path : path.parent_path()).filename().string();
  ReportRun run{.name = fs::path(result.record.pipeline_file).stem().string(),
                .record_json = to_json(result.record),
                .map = result.run.maps.forward,
                .levels = watchers.levels.levels(),
                .explanations_json = explanations};
  const std::string title = scene + ", " + run.name;
  const Scene& seen = result.run.scene;
  const Report report{title, {}, {{scene, seen.pair.base, seen.truth, {std::move(run)}}}};
  write_file(file, report_html(report));
}

/// The map first: what fails later does not take it away. The record last: it tells that all is
/// there.
void write_files(RecordedRun& result, const RecordRequest& request, const Watchers& watchers,
                 RunFolder& folder, KeptMap& kept) {
  folder.begin();
  const DisparityMap& map = result.run.maps.forward;
  if (kept.has_confidence(map)) folder.announce(folder.file(kConfidenceFile));
  kept.write(map);
  if (!result.depth.empty()) {
    const Scene& scene = result.run.scene;
    result.points = write_depth_files(result.depth, map, *scene.calibration, scene.pair.base);
  }
  const std::string explanations =
      watchers.explainer ? to_json(watchers.explainer->explanations()) : "";
  if (!explanations.empty()) write_file(folder.file(kExplanationsFile), explanations);
  result.record.peak_memory_bytes = peak_memory();
  if (request.report) write_report(folder.file(kReportFile), result, watchers, explanations);
  result.record.peak_memory_bytes = peak_memory();
  result.record.outputs = folder.outputs();
  write_file(folder.file(kRecordFile), to_json(result.record));
  folder.end();
}

/// The run and its record, but for what is known when files are written.
RecordedRun match(const Pipeline& pipeline, SceneInputs inputs, const RecordRequest& request,
                  const RunOptions& options, Watchers& watchers, KeptMap& kept,
                  const Keeping& keeping) {
  RunOptions watched = options;
  watched.observer = &watchers.all;
  watched.kept = keeping.results();
  request.tell("matching");
  RecordedRun result{
      kept.match(pipeline, std::move(inputs), watched, request.parts), {}, {}, 0, {}};
  RunRecord& record = result.record;
  record.pipeline_file = pipeline.file();
  record.resolved_pipeline = pipeline.resolved_json();
  record.overrides = request.overrides;
  record.command_line = request.command_line;
  record.threads = options.threads > 0 ? options.threads : thread_count();
  describe_run(record, result.run, watchers);
  record.reused = keeping.reused();
  record.reused_from = keeping.folder();
  describe_map(record, result.run, kept.summary());
  record.peak_memory_bytes = peak_memory();
  result.failure = failure_of(record);
  add_warnings(result, kept.summary(), request, options.observer);
  return result;
}

}  // namespace

RecordedRun record_scene(const Pipeline& pipeline, const SceneRequest& scene,
                         const RecordRequest& request, const RunOptions& options) {
  check_scene(scene, pipeline);
  check_keeping(request, scene);
  const DepthFiles depth = check_depth_files(request.depth, scene, request.folder);
  RunFolder folder(request.folder, planned_files(request, depth),
                   files_read(pipeline, scene, request));
  request.tell("reading the images");
  SceneInputs inputs = read_inputs(pipeline, scene, request);
  require_cameras_of_size(depth, scene, inputs.scene.size());
  KeptMap kept(request.folder);
  kept.add_bytes(inputs);
  if (request.report) add_bytes_of_report(inputs);
  Watchers watchers(request, inputs.scene, &folder, options.observer);
  Keeping keeping = keep_scene(pipeline, scene, inputs, request, options.observer);
  RecordedRun result = [&] {
    try {
      return match(pipeline, std::move(inputs), request, options, watchers, kept, keeping);
    } catch (const Cancelled&) {
      folder.discard();
      throw;
    }
  }();
  request.tell("writing the results");
  result.depth = depth;
  write_files(result, request, watchers, folder, kept);
  keeping.end();
  return result;
}

RecordedRun record_in_memory(const Pipeline& pipeline, const SceneRequest& scene,
                             const RecordRequest& request, const RunOptions& options) {
  if (!request.dump.empty() || request.report || !request.explained.empty() ||
      !request.depth.empty() || request.keep) {
    throw UsageError(
        "dumps, reports, explanations, depths and what is kept are files; give an output folder");
  }
  request.tell("reading the images");
  SceneInputs inputs = read_scene(scene, pipeline);
  KeptMap kept("");  // in memory, too
  Watchers watchers(request, inputs.scene, nullptr, options.observer);
  return match(pipeline, std::move(inputs), request, options, watchers, kept, Keeping());
}

}  // namespace xgm
