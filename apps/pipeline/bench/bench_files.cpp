// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_files.hpp"

#include <filesystem>

#include "options/scene_request.hpp"

namespace xgm::cli {
namespace {

namespace fs = std::filesystem;

std::vector<NamedFile> files_read(const BenchOptions& options, const BenchRequest& request,
                                  const Registry& registry) {
  std::vector<NamedFile> files;
  const auto add = [&](const std::vector<NamedFile>& more) {
    files.insert(files.end(), more.begin(), more.end());
  };
  for (const BenchPipeline& pipeline : request.pipelines) add({{"pipeline", pipeline.file}});
  for (const BenchScene& scene : request.scenes) {
    add(files_of(scene.files));
    add(files_of(scene.files.truth));
  }
  for (const std::string& folder : options.data) {
    add(files_beside_scene(registry, folder, options.dataset));
  }
  return files;
}

std::vector<NamedFile> files_written(const BenchRequest& request) {
  std::vector<NamedFile> files;
  const auto add = [&](const std::string& file) { files.push_back({"--output", file}); };
  for (const BenchTable& table : kBenchTables) {
    add((fs::path(request.output) / table.file).string());
  }
  for (std::size_t scene = 0; scene < request.scenes.size(); ++scene) {
    for (std::size_t i = 0; i < request.pipelines.size(); ++i) {
      for (const std::string& file : cell_files(cell_folder(request, i, scene))) add(file);
    }
  }
  return files;
}

/// Of an earlier bench, whose uploads are made anew.
std::vector<NamedFile> files_replaced(const BenchRequest& request) {
  std::vector<NamedFile> files;
  std::error_code missing;
  const fs::path folder = fs::path(request.output) / "submit";
  for (const auto& entry : fs::recursive_directory_iterator(folder, missing)) {
    if (!entry.is_directory()) files.push_back({"--submit", entry.path().string()});
  }
  return files;
}

}  // namespace

void require_inputs_kept(const BenchOptions& options, const BenchRequest& request,
                         const Registry& registry) {
  std::vector<NamedFile> written = files_written(request);
  if (!options.submit.empty()) {
    for (NamedFile& file : files_replaced(request)) written.push_back(std::move(file));
  }
  require_apart(files_read(options, request, registry), written);
}

}  // namespace xgm::cli
