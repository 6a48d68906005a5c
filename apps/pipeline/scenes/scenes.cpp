// SPDX-License-Identifier: Apache-2.0
// pipeline scenes: what is there to match in a folder, and what is known of it?
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>

#include "commands.hpp"
#include "options/scene_options.hpp"
#include "xgm/io/scene.hpp"

namespace xgm::cli {
namespace {

struct Options {
  std::string folder;
  std::string dataset;
  bool json = false;
  PluginOptions plugins;
};

std::string range_of(const SceneFiles& scene) {
  if (!scene.disparities) return "-";
  return fmt::format("{}:{}", scene.disparities->begin, scene.disparities->end - 1);
}

std::string truth_of(const SceneFiles& scene) {
  const TruthFiles& truth = scene.truth;
  if (truth.disparity.file.empty()) return "-";
  return truth.reverse.file.empty() ? "left" : "both";
}

/// Where the mask of the pixels that are not occluded comes from.
std::string mask_of(const SceneFiles& scene) {
  const TruthFiles& truth = scene.truth;
  if (truth.disparity.file.empty()) return "-";
  if (!truth.non_occluded.empty()) return "file";
  return truth.visible.file.empty() && truth.reverse.file.empty() ? "-" : "from truth";
}

using SceneNames = std::vector<std::string>;

/// The names, or how many more there are.
std::string who(const SceneNames& names, std::size_t scenes) {
  if (names.size() == scenes && names.size() > 1) return "all scenes";
  constexpr std::size_t kMaxNames = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNames); ++i) {
    text += (i > 0 ? ", " : "") + names[i];
  }
  if (names.size() > kMaxNames) text += fmt::format(" and {} more", names.size() - kMaxNames);
  return text;
}

/// Each sentence once, with all scenes that it is true of.
void print_sentences(const std::string& heading, const std::map<std::string, SceneNames>& sentences,
                     std::size_t scenes) {
  if (!sentences.empty()) std::cout << '\n' << heading << ":\n";
  for (const auto& [sentence, names] : sentences) {
    std::cout << "  " << sentence << "\n    in " << who(names, scenes) << '\n';
  }
}

void print_what_is_wrong(const std::vector<SceneFiles>& scenes) {
  std::map<std::string, SceneNames> faulty, lacking;
  for (const SceneFiles& scene : scenes) {
    for (const FileFault& fault : scene.faults) faulty[fault.message].push_back(scene.name);
    for (const std::string& what : scene.missing) lacking[what].push_back(scene.name);
  }
  print_sentences("Faulty", faulty, scenes.size());
  print_sentences("Missing", lacking, scenes.size());
}

void print(const std::vector<SceneFiles>& scenes) {
  std::size_t width = std::string("scene").size();
  for (const SceneFiles& scene : scenes) width = std::max(width, scene.name.size());
  std::cout << scenes.size() << (scenes.size() == 1 ? " scene" : " scenes") << " of data set "
            << scenes.front().dataset << "\n\n";
  const auto row = [&](const auto&... cells) {
    std::cout << fmt::format("{:<{}}  {:>11}  {:<5}  {:<10}  {:<11}  {:>6}  {:>5}\n", cells...);
  };
  row("scene", width, "disparities", "truth", "mask", "calibration", "weight", "scale");
  for (const SceneFiles& scene : scenes) {
    row(scene.name, width, range_of(scene), truth_of(scene), mask_of(scene),
        scene.calibration ? "yes" : "-", scene.weight, scene.scale);
  }
  print_what_is_wrong(scenes);
}

int list_scenes(const Options& options) {
  const Registry registry = make_registry(options.plugins);
  const std::vector<SceneFiles> scenes = find_scenes(options.folder, registry, options.dataset);
  if (options.json) {
    std::cout << to_json(scenes) << '\n';
  } else {
    print(scenes);
  }
  return kOk;
}

}  // namespace

void add_scenes(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command =
      line.add("scenes", "List the scenes in a folder, what is known of them and what is missing",
               [options] { return list_scenes(*options); });
  command.option("folder", options->folder, "A scene, or a folder of scenes")
      .type_name("FOLDER")
      .required();
  add_dataset_option(command, options->dataset);
  command.flag("--json", options->json, "For programs: a list of objects");
  add_plugin_options(command, options->plugins);
}

}  // namespace xgm::cli
