// SPDX-License-Identifier: Apache-2.0
// pipeline bench: many pipelines on many scenes.
#include "xgm/evaluation/bench.hpp"
#include "terminal/console.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "bench/bench_files.hpp"
#include "bench/bench_maps.hpp"
#include "bench/bench_run.hpp"
#include "bench/bench_surfaces.hpp"
#include "commands.hpp"
#include "options/surfaces.hpp"
#include "options/values.hpp"
#include "xgm/evaluation/bench_submission.hpp"

namespace xgm::cli {
namespace {

std::vector<Override> joined(std::vector<Override> first, const std::vector<Override>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

struct NamedPipelines {
  std::vector<BenchPipeline> pipelines;
  std::size_t surfaces = 0;  ///< of them, that make surfaces
};

/// All pipelines with all points of the sweeps; says all that is wrong, and then gives nothing.
std::optional<NamedPipelines> load_pipelines(const BenchOptions& options,
                                             const Registry& registry) {
  const std::vector<Override> overrides = parse_overrides(options.assignments);
  std::vector<Sweep> sweeps;
  for (const std::string& text : options.sweeps) sweeps.push_back(parse_sweep(text));
  NamedPipelines named;
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
      if (makes_surfaces(*pipeline)) ++named.surfaces;
      named.pipelines.push_back(
          {.name = std::filesystem::path(pipeline->file()).stem().string() + point.name,
           .file = pipeline->file(),
           .overrides = all,
           .resolved = pipeline->resolved_json(),
           .disparities = pipeline->disparities()});
    }
  }
  if (!sound) return std::nullopt;
  if (named.surfaces > 0 && named.surfaces < named.pipelines.size()) {
    throw UsageError(
        "--pipelines: some make surfaces and some maps of disparities; compare them in benches of "
        "their own");
  }
  name_folders(named.pipelines);
  return named;
}

std::vector<BenchFile> tables(const BenchResult& result) {
  std::vector<BenchFile> files;
  for (const BenchTable& table : kBenchTables) {
    files.push_back({(std::filesystem::path(result.request.output) / table.file).string(),
                     [&result, text = table.text] { return text(result); }});
  }
  return files;
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

int bench_maps(const BenchOptions& options, const Registry& registry,
               std::vector<BenchPipeline> pipelines, const BenchRules& rules) {
  if (options.fused) throw UsageError("--fused: is for pipelines that make surfaces");
  const BenchRequest request = before_any_run([&] {
    BenchRequest all = bench_request(options, registry, std::move(pipelines), rules);
    if (!options.submit.empty()) check_submission(all, options.submit, options.method);
    require_inputs_kept(options, all, registry);
    identify_images(all.scenes);
    return all;
  });
  const auto lock = hold_output(options);
  const Interruptible interruptible;
  Progress progress;
  const BenchHooks hooks = bench_hooks(options, request.threads, progress);
  progress.begin("looking for what is done already");
  const BenchResult result = run_bench(request, rules, hooks);
  write_tables(bench_text(result), tables(result), progress);
  if (!options.submit.empty()) submit(result, options);
  return exit_code(result.interrupted, result.failures());
}

int bench(const BenchOptions& options) {
  if (!options.memory_limit.empty()) parse_bytes(options.memory_limit, "--memory-limit");
  const BenchRules rules = rules_of(options);
  const Registry registry = before_any_run([&] { return make_registry(options.plugins); });
  auto named = before_any_run([&] { return load_pipelines(options, registry); });
  if (!named) return kUsage;
  if (named->surfaces > 0) return bench_surfaces(options, registry, std::move(named->pipelines));
  return bench_maps(options, registry, std::move(named->pipelines), rules);
}

}  // namespace

void add_bench(CommandLine& line) {
  auto options = std::make_shared<BenchOptions>();
  add_bench_options(line.add("bench", "Run pipelines on the scenes of data sets, and compare them",
                             [options] { return bench(*options); }),
                    *options);
}

}  // namespace xgm::cli
