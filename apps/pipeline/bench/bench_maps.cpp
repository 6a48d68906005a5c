// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_maps.hpp"

#include <filesystem>

#include "bench/bench_run.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::cli {
namespace {

std::vector<std::string> input_words(const BenchOptions& options, const BenchPipeline& pipeline,
                                     const BenchScene& scene) {
  std::vector<std::string> words{"--scene=" + scene.files.name};
  if (!options.dataset.empty()) words.push_back("--dataset=" + options.dataset);
  words.insert(words.end(), {"--", pipeline.file, scene.data_folder});
  return words;
}

}  // namespace

BenchRequest bench_request(const BenchOptions& options, const Registry& registry,
                           std::vector<BenchPipeline> pipelines, const BenchRules& rules) {
  BenchRequest request{
      .output = options.output,
      .pipelines = std::move(pipelines),
      .scenes = find_bench_scenes(options.data, registry, options.dataset, options.scenes),
      .program = identify_program(kThisProgram, plugin_files(registry)),
      .threads = options.threads > 0 ? options.threads : thread_count()};
  check_bench(request, rules);
  return request;
}

BenchHooks bench_hooks(const BenchOptions& options, int threads, Progress& progress) {
  return {.run =
              [&options, threads](const BenchPipeline& pipeline, const BenchScene& scene,
                                  const std::string& folder) {
                return run_program(kThisProgram,
                                   run_words(options, threads, pipeline, folder,
                                             input_words(options, pipeline, scene)),
                                   (std::filesystem::path(folder) / kCellLog).string());
              },
          .tell = [&progress](const BenchProgress& at) { tell(at, progress); }};
}

}  // namespace xgm::cli
