// SPDX-License-Identifier: Apache-2.0
// pipeline tiles: one scene matched by many processes.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/output_files.hpp"
#include "options/scene_request.hpp"
#include "options/values.hpp"
#include "terminal/console.hpp"
#include "terminal/observer.hpp"
#include "terminal/stop_on_signal.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/text.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/io/write_maps.hpp"
#include "xgm/tiles/jobs.hpp"

namespace xgm::cli {
namespace {

namespace fs = std::filesystem;
using tiles::JobManifest;
using tiles::TileJob;

constexpr const char* kManifest = "manifest.json";

struct PlanOptions : SceneOptions {
  std::string tiles = "auto";
  std::string output;
};

struct JobOptions {
  std::string manifest;
  std::string job;
  std::string output;
  int threads = 0;
  std::string log_level = "info";
};

void print(const JobManifest& manifest) {
  double memory = 0, seconds = 0;
  for (const TileJob& job : manifest.jobs) {
    memory = std::max(memory, job.memory_bytes);
    seconds += job.seconds;
  }
  std::cout << fmt::format(
      "{}: {} jobs in tiles of up to {} x {} px\neach takes up to {} and {} thread{}; together "
      "about {:.0f} s\n",
      manifest.file, manifest.jobs.size(), manifest.tiles.size.width, manifest.tiles.size.height,
      bytes_text(memory), manifest.threads, manifest.threads == 1 ? "" : "s", seconds);
}

/// Images in files, which jobs open again. No truth is compared.
const SceneFiles& files_of_jobs(SceneRequest& request) {
  auto* const files = std::get_if<SceneFiles>(&request.scene);
  if (files == nullptr)
    throw UsageError("jobs need images in files: give a SCENE_DIR, or --left and --right");
  files->truth = {};
  return *files;
}

int plan(const PlanOptions& options) {
  set_up_logging(options.log_level);
  const std::optional<cv::Size> size = parse_tiles(options.tiles);
  if (!size && options.memory_limit.empty()) {
    throw UsageError(
        "say what one job may take, --memory-limit SIZE, or how large tiles are, --tiles "
        "WIDTHxHEIGHT");
  }
  const Registry registry = make_registry(options.plugins);
  const auto pipeline =
      load_named(options.pipeline, registry, parse_overrides(options.assignments));
  if (!pipeline) return kUsage;
  SceneRequest request = scene_request(options, registry);
  const SceneFiles& files = files_of_jobs(request);
  const std::string file = (fs::path(options.output) / kManifest).string();
  require_outputs_apart(files_read(options, request, {*pipeline}, registry), {{"--output", file}});
  make_output_folder(options.output);
  request.scratch = options.output;
  Progress progress;
  progress.begin("looking at the images");
  const SceneInputs inputs = read_scene(request, *pipeline);
  show_notes(inputs);
  progress.begin("planning");
  JobManifest manifest = tiles::plan_jobs(*pipeline, inputs, files.images, size, file,
                                          {.threads = use_threads(options.threads)});
  for (const std::string& plugin : options.plugins.files) {
    manifest.plugins.push_back(fs::absolute(plugin).string());
  }
  tiles::write_manifest(manifest);
  progress.end();
  print(manifest);
  return kOk;
}

Pipeline pipeline_of(const JobManifest& manifest, const Registry& registry) {
  LoadedPipeline loaded = load_pipeline_text(manifest.pipeline, manifest.file, registry);
  if (loaded.pipeline) return *loaded.pipeline;
  std::string text = manifest.file + ": its pipeline cannot be loaded here";
  for (const Diagnostic& diagnostic : loaded.diagnostics) text += "\n" + to_string(diagnostic);
  throw UsageError(text);
}

int run_one(const JobOptions& options) {
  set_up_logging(options.log_level);
  const JobManifest manifest = tiles::read_manifest(options.manifest);
  const TileJob& job = tiles::find_job(manifest, options.job);
  const Registry registry = make_registry({manifest.plugins});
  const Pipeline pipeline = pipeline_of(manifest, registry);
  Progress progress;
  progress.begin(job.name);
  TerminalObserver observer(progress);
  const StopOnSignal stop;
  try {
    const int threads = use_threads(options.threads > 0 ? options.threads : manifest.threads);
    const bool was_missing = tiles::run_job(
        manifest, job, pipeline, {.observer = &observer, .threads = threads, .stop = stop.token()});
    progress.end();
    std::cout << job.name << (was_missing ? ": done\n" : ": was done before\n");
    return kOk;
  } catch (const Cancelled&) {
    log_warning("interrupted; nothing of this job is left");
    return kSignalled + Interruptible::signal();
  }
}

int join(const JobOptions& options) {
  set_up_logging(options.log_level);
  const JobManifest manifest = tiles::read_manifest(options.manifest);
  const std::string folder =
      options.output.empty() ? fs::absolute(manifest.file).parent_path().string() : options.output;
  std::vector<NamedFile> read{{"manifest", manifest.file}}, written;
  for (const InputFile& input : manifest.inputs) read.push_back({input.role, input.file});
  for (const char* name : kMapFiles) {
    written.push_back({"--output", (fs::path(folder) / name).string()});
  }
  written.push_back({"--output", (fs::path(folder) / kConfidenceFile).string()});
  require_outputs_apart(read, written);
  const MapSummary summary = tiles::join_jobs(manifest, folder);
  std::cout << fmt::format("map:     {} x {}, {:.2f} % of the pixels have a disparity\nwritten:",
                           manifest.size.width, manifest.size.height, 100 * summary.density());
  for (const NamedFile& file : written) {
    if (fs::exists(file.file)) std::cout << ' ' << file.file;  // not all maps have a confidence
  }
  std::cout << '\n' << std::flush;
  if (summary.density() > 0) return kOk;
  log_error("the map is empty: no pixel has a disparity");
  return kFailed;
}

void add_tiles_plan(CommandLine& line) {
  auto options = std::make_shared<PlanOptions>();
  Command command =
      line.add("tiles plan", "Write a manifest of jobs", [options] { return plan(*options); });
  add_pipeline(command, *options);
  add_scene_or_images(command, *options);
  add_interval(command, *options);
  add_matching(command, *options);
  command
      .option("--memory-limit", options->memory_limit,
              "What one job may take; tiles are as large as "
              "that allows")
      .type_name("SIZE");
  command.option("--tiles", options->tiles, "Size of the tiles in px")
      .type_name("auto|WIDTHxHEIGHT")
      .show_default();
  command
      .option("-o,--output", options->output,
              "Folder for manifest.json and the results of the jobs, that all machines see")
      .type_name("DIR")
      .required();
  add_surroundings(command, *options);
}

void add_manifest(Command command, JobOptions& options) {
  command.option("manifest", options.manifest, "The manifest.json of pipeline tiles plan")
      .type_name("MANIFEST")
      .existing_file()
      .required();
}

}  // namespace

void add_tiles(CommandLine& line) {
  line.add_group("tiles", "Match a scene by many processes, on one machine or many");
  add_tiles_plan(line);
  auto one = std::make_shared<JobOptions>();
  Command run = line.add("tiles run", "Do one job", [one] { return run_one(*one); });
  add_manifest(run, *one);
  run.option("job", one->job, "Its name in the manifest").type_name("JOB").required();
  add_threads_option(run, one->threads, "Threads to use; without it those of the plan");
  add_log_level_option(run, one->log_level);
  auto all = std::make_shared<JobOptions>();
  Command join_command =
      line.add("tiles join", "Make one map of the jobs' results", [all] { return join(*all); });
  add_manifest(join_command, *all);
  join_command
      .option("-o,--output", all->output, "Folder for the map; without it that of the manifest")
      .type_name("DIR");
  add_log_level_option(join_command, all->log_level);
}

}  // namespace xgm::cli
