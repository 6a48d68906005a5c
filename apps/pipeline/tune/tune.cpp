// SPDX-License-Identifier: Apache-2.0
// pipeline tune: good values of a pipeline's parameters.
#include "xgm/evaluation/tune.hpp"

#include <filesystem>
#include <memory>

#include "bench/bench_files.hpp"
#include "bench/bench_maps.hpp"
#include "bench/bench_run.hpp"
#include "commands.hpp"
#include "options/surfaces.hpp"
#include "tune/tune_options.hpp"
#include "xgm/io/require_apart.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::cli {
namespace {

namespace fs = std::filesystem;

std::vector<Override> joined(std::vector<Override> first, const std::vector<Override>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Makes pipelines of points.
class Candidates {
 public:
  Candidates(const TuneOptions& options, const Registry& registry)
      : registry_(registry),
        file_(find_pipeline(options.pipeline)),
        overrides_(parse_overrides(options.bench.assignments)) {}

  bool is_sound(const std::vector<Override>& point) const {
    return load_pipeline(file_, registry_, joined(overrides_, point)).pipeline.has_value();
  }
  /// Says what is wrong with the point; whether anything is.
  bool is_refused(const std::vector<Override>& point) const {
    return !load_named(file_, registry_, joined(overrides_, point));
  }
  BenchPipeline pipeline(const SweepPoint& point) const {
    const std::vector<Override> all = joined(overrides_, point.overrides);
    const Pipeline loaded = require_pipeline(file_, registry_, all);
    require_pair_pipeline(loaded, "tune", "pipeline bench compares those that make surfaces");
    return {.name = fs::path(file_).stem().string() + point.name,
            .file = file_,
            .overrides = all,
            .resolved = loaded.resolved_json(),
            .disparities = loaded.disparities()};
  }

 private:
  const Registry& registry_;
  std::string file_;
  std::vector<Override> overrides_;
};

std::vector<BenchFile> outputs(const TuneResult& result) {
  const auto file = [&](const char* name, std::string (*text)(const TuneResult&)) {
    return BenchFile{(fs::path(result.request.bench.output) / name).string(),
                     [&result, text] { return text(result); }};
  };
  return {file("tune.md", tune_markdown), file("tune.json", tune_json),
          file("best.yaml", best_yaml)};
}

/// An output of an earlier tuning may be the pipeline of this one.
void require_pipeline_kept(const TuneRequest& request) {
  TuneResult none;
  none.request.bench.output = request.bench.output;
  std::vector<NamedFile> written;
  for (const BenchFile& file : outputs(none)) written.push_back({"--output", file.file});
  require_apart({{"pipeline", request.bench.pipelines.front().file}}, written);
}

TuneRequest make_request(const TuneOptions& options, const Registry& registry,
                         const std::vector<TuneParameter>& parameters,
                         const Candidates& candidates) {
  TuneRequest request{.rules = options.rules(), .held_out = options.held_out, .seed = options.seed};
  request.bench = bench_request(options.bench, registry, {candidates.pipeline({})}, request.rules);
  const std::size_t scenes = request.bench.scenes.size();
  const std::size_t held_out = held_out_count(options.held_out, scenes);
  const std::size_t count =
      affordable_pipelines(static_cast<std::size_t>(options.budget), scenes - held_out, held_out);
  const auto is_sound = [&](const auto& point) { return candidates.is_sound(point); };
  for (const SweepPoint& point : draw_points(parameters, count - 1, is_sound, options.seed)) {
    request.bench.pipelines.push_back(candidates.pipeline(point));
  }
  name_folders(request.bench.pipelines);
  require_inputs_kept(options.bench, request.bench, registry);
  require_pipeline_kept(request);
  identify_images(request.bench.scenes);
  return request;
}

int tune(const TuneOptions& options) {
  options.check();
  const auto parameters = before_any_run([&] { return parse_tune_parameters(options.parameters); });
  const Registry registry = make_registry(options.bench.plugins);
  const Candidates candidates(options, registry);
  if (candidates.is_refused({})) return kUsage;
  const auto useless = useless_value(
      parameters, [&](const auto& point) { return candidates.is_sound(point); }, options.seed);
  if (!useless.empty() && candidates.is_refused(useless)) return kUsage;
  const TuneRequest request =
      before_any_run([&] { return make_request(options, registry, parameters, candidates); });
  const auto lock = hold_output(options.bench);
  const Interruptible interruptible;
  Progress progress;
  progress.begin("looking for what is done already");
  const TuneResult result =
      run_tune(request, bench_hooks(options.bench, request.bench.threads, progress));
  if (!result.interrupted) write_tables(tune_text(result), outputs(result), progress);
  return exit_code(result.interrupted, result.best().failure.empty() ? 0 : 1);
}

}  // namespace

void add_tune(CommandLine& line) {
  auto options = std::make_shared<TuneOptions>();
  add_tune_options(line.add("tune", "Find good values of a pipeline's parameters",
                            [options] { return tune(*options); }),
                   *options);
}

}  // namespace xgm::cli
