// SPDX-License-Identifier: Apache-2.0
// The scenes that a bench is about.
#include <algorithm>
#include <filesystem>
#include <set>

#include "bench/names.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/suggest.hpp"
#include "xgm/evaluation/bench.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {
namespace {

void keep_named(std::vector<BenchScene>& scenes, const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const BenchScene& scene : scenes) known.push_back(scene.files.name);
  const auto holds = [](const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  for (const std::string& name : names) {
    if (holds(known, name)) continue;
    throw Error("there is no scene '" + name + "'; " + suggest(name, known, "scenes"));
  }
  std::erase_if(scenes, [&](const BenchScene& scene) { return !holds(names, scene.files.name); });
}

}  // namespace

std::vector<BenchScene> find_bench_scenes(const std::vector<std::string>& folders,
                                          const Registry& registry, const std::string& dataset,
                                          const std::vector<std::string>& names) {
  std::vector<BenchScene> scenes;
  std::set<std::pair<std::filesystem::path, std::string>> known;
  std::error_code ignored;
  for (const std::string& folder : folders) {
    for (SceneFiles& files : find_scenes(folder, registry, dataset)) {
      const auto left = std::filesystem::weakly_canonical(files.images.left, ignored);
      // Scenes may share an image: the same left one with a right one of another exposure.
      const bool is_first = known.insert({left, files.name}).second;
      if (!is_first && !files.images.left.empty()) continue;
      scenes.push_back({.set = {}, .data_folder = folder, .files = std::move(files)});
    }
  }
  if (!names.empty()) keep_named(scenes, names);
  name_sets(scenes);
  return scenes;
}

}  // namespace xgm
