// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_surfaces.hpp"

#include "xgm/base/error.hpp"

#ifdef XGM_HAS_GEO
#include <algorithm>
#include <array>
#include <filesystem>

#include "bench/bench_run.hpp"
#include "command_line/command_line.hpp"
#include "options/scene_request.hpp"
#include "options/surfaces.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/base/suggest.hpp"
#include "xgm/geo/bench/surface_bench.hpp"
#include "xgm/geo/run/recorded_surface.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/require_apart.hpp"
#include "xgm/pipeline/lookup.hpp"
#endif

namespace xgm::cli {

#ifdef XGM_HAS_GEO
namespace {

namespace fs = std::filesystem;

void refuse_stereo_options(const BenchOptions& options) {
  refuse_for_surfaces({
      {"--dataset", !options.dataset.empty(), "their scenes have a scene.yaml"},
      {"--submit", !options.submit.empty(), "no benchmark takes them"},
      {"--thresholds", !options.thresholds.empty(), "heights are judged within 1 m"},
      {"--scale", options.scale != "1", "heights are judged in m"},
      {"--clip", options.rules.clip, "heights are judged as they are"},
      {"--region", !options.rules.region.empty(), "what all images see is judged"},
      {"--memory-limit", !options.memory_limit.empty(),
       "smaller windows take less memory: --set tile=1000"},
  });
}

std::vector<geo::SurfaceScene> find_scenes(const BenchOptions& options) {
  std::vector<geo::SurfaceScene> scenes;
  std::vector<std::string> known;
  for (const std::string& folder : options.data) {
    for (const geo::SurfaceScene& scene : geo::find_surface_scenes(folder)) {
      known.push_back(scene.name);
      const auto& names = options.scenes;
      const bool wanted = names.empty() || std::count(names.begin(), names.end(), scene.name) > 0;
      if (!wanted) continue;
      const auto parts = options.fused ? std::vector{scene} : geo::pairs_of(scene);
      scenes.insert(scenes.end(), parts.begin(), parts.end());
    }
  }
  for (const std::string& name : options.scenes) {
    if (std::count(known.begin(), known.end(), name) == 0)
      throw UsageError("there is no scene '" + name + "'; " + suggest(name, known, "scenes"));
  }
  return scenes;
}

struct SurfaceTable {
  const char* file;
  std::string (*text)(const geo::SurfaceBenchResult&);
};
constexpr std::array kTables{SurfaceTable{"bench.md", geo::surface_bench_markdown},
                             SurfaceTable{"bench.csv", geo::surface_bench_csv},
                             SurfaceTable{"bench.json", geo::surface_bench_json},
                             SurfaceTable{"bench.html", geo::surface_bench_html}};

std::vector<BenchFile> tables(const geo::SurfaceBenchResult& result) {
  std::vector<BenchFile> files;
  for (const SurfaceTable& table : kTables) {
    files.push_back({(fs::path(result.request.output) / table.file).string(),
                     [&result, text = table.text] { return text(result); }});
  }
  return files;
}

/// Inputs lie in none of the folders that runs write to.
void require_inputs_apart(const geo::SurfaceBenchRequest& request) {
  std::vector<NamedFile> read, written;
  for (const BenchPipeline& pipeline : request.pipelines)
    read.push_back({"pipeline", pipeline.file});
  for (const geo::SurfaceScene& scene : request.scenes) {
    const std::vector<NamedFile> files = geo::files_of(scene.files);
    read.insert(read.end(), files.begin(), files.end());
    for (const std::string& file : scene.files.visible) read.push_back({"visible", file});
  }
  for (const SurfaceTable& table : kTables) {
    written.push_back({"--output", (fs::path(request.output) / table.file).string()});
  }
  for (std::size_t scene = 0; scene < request.scenes.size(); ++scene) {
    for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
      const std::string folder = geo::cell_folder(request, i, scene);
      for (const std::string& file : job_files(folder)) written.push_back({"--output", file});
      for (const std::string& name : geo::output_names(request.scenes[scene].files)) {
        written.push_back({"--output", (fs::path(folder) / name).string()});
      }
    }
  }
  require_apart(read, written);
}

std::vector<std::string> input_words(const BenchPipeline& pipeline,
                                     const geo::SurfaceScene& scene) {
  const auto whole = [](const std::string& file) { return fs::absolute(file).string(); };
  const geo::SurfaceFiles& files = scene.files;
  std::vector<std::string> words{"--truth=" + whole(files.truth)};
  if (files.band > 0) words.push_back("--band=" + std::to_string(files.band));
  if (!files.area.empty())
    words.push_back("--area=" + (fs::exists(files.area) ? whole(files.area) : files.area));
  const auto add = [&](const std::string& option, const std::vector<std::string>& names) {
    if (names.empty()) return;
    words.push_back(option);
    for (const std::string& name : names) words.push_back(whole(name));
  };
  add("--masks", files.masks);
  add("--cameras", files.cameras);
  add("--dem", files.dem);
  add("--images", files.images);
  words.insert(words.end(), {"--", pipeline.file});
  return words;
}

geo::SurfaceBenchRequest make_request(const BenchOptions& options, const Registry& registry,
                                      std::vector<BenchPipeline> pipelines) {
  refuse_stereo_options(options);
  std::vector<std::string> files = plugin_files(registry);
  files.push_back(geo::surface_library());
  geo::SurfaceBenchRequest request{
      .output = options.output,
      .pipelines = std::move(pipelines),
      .scenes = find_scenes(options),
      .program = identify_program(kThisProgram, files),
      .threads = options.threads > 0 ? options.threads : thread_count()};
  require_inputs_apart(request);
  return request;
}

}  // namespace

int bench_surfaces(const BenchOptions& options, const Registry& registry,
                   std::vector<BenchPipeline> pipelines) {
  const auto request =
      before_any_run([&] { return make_request(options, registry, std::move(pipelines)); });
  const auto lock = hold_output(options);
  const Interruptible interruptible;
  Progress progress;
  const geo::SurfaceBenchHooks hooks{
      .run =
          [&](const BenchPipeline& pipeline, const geo::SurfaceScene& scene,
              const std::string& folder) {
            return run_program(
                kThisProgram,
                run_words(options, request.threads, pipeline, folder, input_words(pipeline, scene)),
                (fs::path(folder) / kCellLog).string());
          },
      .tell = [&](const BenchProgress& at) { tell(at, progress); }};
  progress.begin("looking for what is done already");
  const geo::SurfaceBenchResult result = geo::run_surface_bench(request, hooks);
  write_tables(geo::surface_bench_text(result), tables(result), progress);
  return exit_code(result.interrupted, result.failures());
}
#else
int bench_surfaces(const BenchOptions&, const Registry&, std::vector<BenchPipeline>) {
  throw UsageError("this program was built without GDAL and PROJ");
}
#endif

}  // namespace xgm::cli
