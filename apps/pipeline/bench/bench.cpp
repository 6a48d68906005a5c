// SPDX-License-Identifier: Apache-2.0
// pipeline bench: many pipelines on many scenes.
#include "xgm/evaluation/bench.hpp"
#include "terminal/console.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "bench/bench_options.hpp"
#include "commands.hpp"
#include "options/values.hpp"
#include "terminal/progress.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/evaluation/bench_process.hpp"
#include "xgm/evaluation/bench_submission.hpp"
#include "xgm/evaluation/bench_tables.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::cli {
namespace {

constexpr int kSignalled = 128;  // shells add the signal's number
// Also after it has been built anew, this is what runs.
constexpr const char* kThisProgram = "/proc/self/exe";

std::vector<Override> joined(std::vector<Override> first, const std::vector<Override>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// All pipelines with all points of the sweeps; says all that is wrong, and then gives nothing.
std::optional<std::vector<BenchPipeline>> load_pipelines(const BenchOptions& options,
                                                         const Registry& registry) {
  const std::vector<Override> overrides = parse_overrides(options.assignments);
  std::vector<Sweep> sweeps;
  for (const std::string& text : options.sweeps) sweeps.push_back(parse_sweep(text));
  std::vector<BenchPipeline> pipelines;
  bool sound = true;
  for (const std::string& name : pipeline_names(options)) {
    for (const SweepPoint& point : sweep_points(sweeps)) {
      const std::vector<Override> all = joined(overrides, point.overrides);
      const auto pipeline = load_named(name, registry, all);
      sound = sound && pipeline;
      if (!pipeline) {
        log_error("so pipeline " + name + point.name + " cannot be run");
        continue;
      }
      pipelines.push_back(
          {.name = std::filesystem::path(pipeline->file()).stem().string() + point.name,
           .file = pipeline->file(),
           .overrides = all,
           .resolved = pipeline->resolved_json(),
           .disparities = pipeline->disparities()});
    }
  }
  if (!sound) return std::nullopt;
  name_folders(pipelines);
  return pipelines;
}

std::vector<std::string> plugin_files(const Registry& registry) {
  std::vector<std::string> files;
  for (const PluginInfo* plugin : registry.plugins()) {
    const bool known = std::find(files.begin(), files.end(), plugin->origin) != files.end();
    if (!plugin->origin.empty() && !known) files.push_back(plugin->origin);
  }
  return files;
}

std::optional<BenchRequest> make_request(const BenchOptions& options) {
  const Registry registry = make_registry(options.plugins);
  auto pipelines = load_pipelines(options, registry);
  if (!pipelines) return std::nullopt;
  BenchRequest request{
      .output = options.output,
      .pipelines = std::move(*pipelines),
      .scenes = find_bench_scenes(options.data, registry, options.dataset, options.scenes),
      .program = identify_program(kThisProgram, plugin_files(registry)),
      .threads = options.threads > 0 ? options.threads : thread_count()};
  check_bench(request, options.rules);
  if (!options.submit.empty()) check_submission(request, options.submit, options.method);
  identify_images(request.scenes);
  return request;
}

/// The command line of one cell's run.
std::vector<std::string> run_words(const BenchOptions& options, const BenchRequest& request,
                                   const BenchPipeline& pipeline, const BenchScene& scene,
                                   const std::string& folder) {
  std::vector<std::string> words{"pipeline", "run"};
  // With "=", for values may begin with a dash.
  const auto add = [&](const std::string& option, const std::string& value) {
    words.push_back(option + "=" + value);
  };
  add("--scene", scene.files.name);
  add("--output", folder);
  add("--threads", std::to_string(request.threads));
  add("--log-level", "warning");
  if (!options.dataset.empty()) add("--dataset", options.dataset);
  if (!options.memory_limit.empty()) add("--memory-limit", options.memory_limit);
  for (const Override& change : pipeline.overrides) {
    add("--set", change.path + "=" + change.value);
  }
  for (const std::string& file : options.plugins.files) add("--plugin", file);
  words.insert(words.end(), {"--", pipeline.file, scene.data_folder});
  return words;
}

/// Says where the bench stands: on the line that is rewritten, and in one that stays.
void tell(const BenchProgress& at, Progress& progress) {
  const std::string left =
      at.seconds_left > 0 ? ", about " + duration_text(at.seconds_left) + " left" : "";
  const std::string what =
      fmt::format("run {} of {}{}: {} on {}", at.number, at.total, left, at.pipeline, at.scene);
  if (!at.finished) {
    progress.begin(what);
  } else if (at.cell->state == CellState::failed) {
    log_warning(what + " failed: " + at.cell->failure);
  } else {
    log_info(
        fmt::format("{}: {:.2f} s, {:.0f} MB", what, at.cell->seconds, at.cell->peak_bytes / 1e6));
  }
}

/// Nothing is printed while the line of the progress stands on the terminal.
void write_tables(const BenchResult& result, Progress& progress) {
  const std::filesystem::path folder(result.request.output);
  progress.end();
  std::cout << bench_text(result) << std::flush;
  progress.begin("writing the tables");
  std::string written = "written:";
  const auto write = [&](const char* name, const std::string& text) {
    const std::string file = (folder / name).string();
    write_file(file, text);
    written += ' ' + file;
  };
  write("bench.md", bench_markdown(result));
  write("bench.csv", bench_csv(result));
  write("bench.json", bench_json(result));
  write("bench.html", bench_html(result));
  progress.end();
  std::cout << written << std::endl;
}

void submit(const BenchResult& result, const BenchOptions& options) {
  const auto commands = write_submission(result, options.submit, options.method);
  if (commands.size() < result.request.pipelines.size()) {
    log_warning("--submit " + options.submit + ": left out are " +
                std::to_string(result.request.pipelines.size() - commands.size()) +
                " pipelines that are not done on all scenes");
  }
  for (const std::string& command : commands) std::cout << "to pack: " << command << '\n';
}

int run_planned(const BenchOptions& options, const BenchRequest& request, const BenchRules& rules) {
  const Interruptible interruptible;
  Progress progress;
  const BenchHooks hooks{
      .run =
          [&](const BenchPipeline& pipeline, const BenchScene& scene, const std::string& folder) {
            return run_program(kThisProgram, run_words(options, request, pipeline, scene, folder),
                               (std::filesystem::path(folder) / "log.txt").string());
          },
      .tell = [&](const BenchProgress& at) { tell(at, progress); }};
  progress.begin("looking for what is done already");
  const BenchResult result = run_bench(request, rules, hooks);
  write_tables(result, progress);
  if (!options.submit.empty()) submit(result, options);
  if (result.interrupted) {
    log_warning("interrupted; the same command goes on from here");
    return kSignalled + Interruptible::signal();
  }
  return result.failures() == 0 ? kOk : kFailed;
}

int bench(const BenchOptions& options) {
  if (!options.memory_limit.empty()) parse_bytes(options.memory_limit, "--memory-limit");
  const BenchRules rules = rules_of(options);
  std::optional<BenchRequest> request;
  std::optional<FolderLock> lock;
  try {
    request = make_request(options);
    if (!request) return kUsage;
    make_output_folder(options.output, "--output ");
    lock.emplace(options.output);
  } catch (const UsageError&) {
    throw;
  } catch (const Error& error) {
    throw UsageError(error.message());
  }
  return run_planned(options, *request, rules);
}

}  // namespace

void add_bench(CommandLine& line) {
  auto options = std::make_shared<BenchOptions>();
  add_bench_options(line.add("bench", "Run pipelines on the scenes of data sets, and compare them",
                             [options] { return bench(*options); }),
                    *options);
}

}  // namespace xgm::cli
