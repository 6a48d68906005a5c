// SPDX-License-Identifier: Apache-2.0
// Many pipelines on many scenes, all in this process.
#include "xgm/evaluation/bench.hpp"

#include <pybind11/stl.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "registry.hpp"
#include "watched.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/evaluation/bench_tables.hpp"
#include "xgm/evaluation/recorded_run.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/pipeline/installation.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::python {
namespace {

/// What a bench is asked for.
struct BenchWishes {
  std::string output{};
  std::vector<std::string> data{};
  std::string dataset{};
  std::vector<std::string> scenes{};
  BenchRules rules{};
  int threads = 0;
  std::vector<std::string> salts{};  ///< what, beside the program's files, decides of results
};

/// Names, and the changes that the pipelines were loaded with.
using NamedPipelines = std::vector<std::tuple<std::string, Pipeline, Changes>>;

BenchRequest request_of(const NamedPipelines& pipelines, const BenchWishes& wishes) {
  BenchRequest request;
  request.output = wishes.output;
  for (const auto& [name, pipeline, changes] : pipelines) {
    request.pipelines.push_back({.name = name,
                                 .file = pipeline.file(),
                                 .overrides = to_overrides(changes),
                                 .resolved = pipeline.resolved_json(),
                                 .disparities = pipeline.disparities()});
  }
  request.scenes = find_bench_scenes(wishes.data, registry(), wishes.dataset, wishes.scenes);
  request.program = identify_program(file_of(reinterpret_cast<const void*>(&bind_bench)),
                                     plugin_files(registry()));
  for (const std::string& salt : wishes.salts) {
    request.program.push_back({salt.size(), std::to_string(fnv1a64(salt))});
  }
  request.threads = wishes.threads > 0 ? wishes.threads : thread_count();
  check_bench(request, wishes.rules);
  name_folders(request.pipelines);
  return request;
}

const Pipeline& pipeline_of(const BenchPipeline& wanted, const BenchRequest& request,
                            const NamedPipelines& pipelines) {
  for (std::size_t i = 0; i < pipelines.size(); ++i) {
    if (request.pipelines[i].name == wanted.name) return std::get<1>(pipelines[i]);
  }
  throw Error("no pipeline is called " + wanted.name);
}

RunOutcome run_cell(const Pipeline& pipeline, const BenchPipeline& named, const BenchScene& scene,
                    const std::string& folder, RunOptions options) {
  options.observer = nullptr;
  try {
    const RecordedRun result = record_scene(
        pipeline, {.scene = scene.files},
        {.folder = folder, .overrides = named.overrides, .command_line = {"python"}}, options);
    return {.interrupted = false, .failure = result.failure};
  } catch (const Cancelled&) {
    return {.interrupted = true, .failure = {}};
  } catch (const std::exception& error) {
    return {.interrupted = false, .failure = error.what()};
  }
}

void tell(const BenchProgress& at, Observer& observer) {
  const std::string what = at.pipeline + " on " + at.scene;
  if (at.finished && !at.figures.failure.empty()) {
    observer.log(LogLevel::warning, {}, what + " failed: " + at.figures.failure);
  }
  StagePlace place;
  place.path = what;
  observer.stage_begin(place);
  observer.progress(static_cast<double>(at.number - (at.finished ? 0 : 1)) /
                    static_cast<double>(at.total));
}

/// JSON and a table for people.
std::pair<std::string, std::string> bench(const NamedPipelines& pipelines,
                                          const BenchWishes& wishes, const Hooks& hooks) {
  make_output_folder(wishes.output);
  const FolderLock lock(wishes.output);
  BenchRequest request = request_of(pipelines, wishes);
  std::pair<std::string, std::string> texts;
  run_watched(hooks, request.threads, [&](const RunOptions& options) {
    identify_images(request.scenes);
    const BenchHooks bench_hooks{
        .run =
            [&](const BenchPipeline& pipeline, const BenchScene& scene, const std::string& folder) {
              return run_cell(pipeline_of(pipeline, request, pipelines), pipeline, scene, folder,
                              options);
            },
        .tell = [&](const BenchProgress& at) { tell(at, *options.observer); }};
    const BenchResult result = run_bench(request, wishes.rules, bench_hooks);
    if (result.interrupted) throw Cancelled();
    texts = {bench_json(result), bench_text(result)};
  });
  return texts;
}

}  // namespace

void bind_bench(py::module_& module) {
  py::class_<BenchRules>(module, "BenchRules")
      .def(
          py::init([](std::vector<double> thresholds, double scale, bool clip, std::string region) {
            return BenchRules{std::move(thresholds), scale, clip, std::move(region)};
          }));
  py::class_<BenchWishes>(module, "BenchWishes")
      .def(py::init<>())
      .def_readwrite("output", &BenchWishes::output)
      .def_readwrite("data", &BenchWishes::data)
      .def_readwrite("dataset", &BenchWishes::dataset)
      .def_readwrite("scenes", &BenchWishes::scenes)
      .def_readwrite("rules", &BenchWishes::rules)
      .def_readwrite("threads", &BenchWishes::threads)
      .def_readwrite("salts", &BenchWishes::salts);
  module.def("bench", &bench);
}

}  // namespace xgm::python
