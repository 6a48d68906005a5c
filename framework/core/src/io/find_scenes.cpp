// SPDX-License-Identifier: Apache-2.0
// Finds the scenes in a folder: which data set it is, and what that makes of it.
#include <algorithm>
#include <filesystem>

#include "plugin/binder.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/file_names.hpp"
#include "xgm/base/suggest.hpp"
#include "xgm/io/file.hpp"
#include "xgm/io/scene.hpp"
#include "xgm/stage/dataset.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

struct Named {
  std::string name;
  std::shared_ptr<const Dataset> dataset;
};

/// Throws UsageError with all that is wrong with the text.
Named bind_dataset(const std::string& yaml, const std::string& place, const Registry& registry) {
  Diagnostics diagnostics;
  const std::optional<Node> node = read_yaml(yaml, place, diagnostics);
  Binder::BoundStage bound;
  if (node) bound = Binder(registry, diagnostics).stage(*node, Dataset::kKind);
  if (bound.stage) return {bound.plugin, std::dynamic_pointer_cast<const Dataset>(bound.stage)};
  throw UsageError(to_string(diagnostics));
}

Named bind_file(const std::string& file, const Registry& registry) {
  return bind_dataset(read_file(file, kMaxYamlBytes), file, registry);
}

/// All that can be asked without parameters.
std::vector<Named> datasets(const Registry& registry) {
  std::vector<Named> found;
  for (const PluginInfo* plugin : registry.plugins(Dataset::kKind)) {
    Diagnostics wanting;
    Node name;
    name.kind = Node::Kind::scalar;
    name.scalar = plugin->name;
    const auto stage = Binder(registry, wanting).stage(name, Dataset::kKind).stage;
    if (stage) found.push_back({plugin->name, std::dynamic_pointer_cast<const Dataset>(stage)});
  }
  return found;
}

void note_if_unusable(SceneFiles& scene, const std::string& file, const std::string& remedy) {
  if (file.empty() || !fault_of(scene, file).empty()) return;
  std::string why = why_unreadable(file);
  std::error_code unusable;
  if (why.empty() && fs::is_empty(file, unusable)) why = "is empty";
  if (!why.empty()) scene.faults.push_back({file, file + ": " + why + "; " + remedy});
}

bool is_absent(const std::string& file) {
  std::error_code unusable;
  const fs::file_type type = fs::symlink_status(file, unusable).type();
  return type == fs::file_type::not_found || type == fs::file_type::directory;
}

/// What lacks an image is listed with the others, and fails only if it is matched.
void note_unusable_images(SceneFiles& scene) {
  for (const std::string& file :
       {scene.images.left, scene.images.right, scene.images.left_mask, scene.images.right_mask}) {
    if (file.empty()) continue;
    if (is_absent(file)) {
      scene.missing.push_back(file + ": without it the scene cannot be matched");
    } else {
      note_if_unusable(scene, file, "without it the scene cannot be matched");
    }
  }
}

void note_unusable_files(SceneFiles& scene) {
  note_unusable_images(scene);
  const TruthFiles& truth = scene.truth;
  for (const std::string& file : {truth.disparity.file, truth.reverse.file, truth.visible.file,
                                  truth.non_occluded, truth.objects}) {
    note_if_unusable(scene, file, "without it maps cannot be judged");
  }
  note_if_unusable(scene, scene.calibration_file, "mend it, or remove it");
}

/// The data set's scenes, their names looked after.
std::vector<SceneFiles> scenes_of(const Named& named, const std::string& folder) {
  std::vector<SceneFiles> scenes = named.dataset->scenes(folder);
  std::sort(scenes.begin(), scenes.end(),
            [](const SceneFiles& a, const SceneFiles& b) { return a.name < b.name; });
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    scenes[i].dataset = named.name;
    note_unusable_files(scenes[i]);
    if (i > 0 && scenes[i].name == scenes[i - 1].name) {
      throw Error(folder + ": holds two scenes called '" + scenes[i].name + "'; rename one");
    }
  }
  return scenes;
}

std::vector<SceneFiles> scenes_that_must_be(const Named& named, const std::string& folder) {
  std::vector<SceneFiles> scenes = scenes_of(named, folder);
  if (!scenes.empty()) return scenes;
  throw Error(folder + ": data set " + named.name + " finds no scene here; it looks for " +
              named.dataset->layout());
}

std::vector<SceneFiles> recognised(const std::string& folder, const Registry& registry) {
  std::vector<std::string> names;
  std::vector<SceneFiles> found;
  std::string layouts;
  for (const Named& named : datasets(registry)) {
    layouts += "\n  " + named.name + ": " + named.dataset->layout();
    std::vector<SceneFiles> scenes = scenes_of(named, folder);
    if (scenes.empty()) continue;
    names.push_back(named.name);
    found = std::move(scenes);
  }
  if (names.size() == 1) return found;
  if (names.empty()) {
    throw Error(folder +
                ": is no scene and holds none of a known layout; give such a folder, or write a "
                "dataset.yaml into it. Known layouts:" +
                layouts);
  }
  throw Error(folder + ": may be any of the data sets " + join(names) +
              "; say which with --dataset NAME");
}

void require_folder(const std::string& folder) {
  std::error_code unusable;
  if (!fs::exists(folder, unusable)) throw Error(folder + ": no such folder; check the path");
  if (!fs::is_directory(folder, unusable)) {
    throw Error(folder + ": is a file; give the folder that holds the scene");
  }
}

std::vector<SceneFiles> find(const std::string& folder, const Registry& registry,
                             const std::string& dataset) {
  require_folder(folder);
  std::error_code unusable;
  if (fs::is_regular_file(dataset, unusable)) {
    return scenes_that_must_be(bind_file(dataset, registry), folder);
  }
  const std::string ending = lower_case(fs::path(dataset).extension().string());
  if (ending == ".yaml" || ending == ".yml") {
    throw Error(dataset + ": no such file; check the path of the data set's description");
  }
  if (!dataset.empty()) {
    return scenes_that_must_be(bind_dataset(dataset, "data set", registry), folder);
  }
  const std::string described = find_path((fs::path(folder) / "dataset.yaml").string());
  if (fs::exists(described, unusable)) {
    return scenes_that_must_be(bind_file(described, registry), folder);
  }
  return recognised(folder, registry);
}

}  // namespace

std::vector<SceneFiles> find_scenes(const std::string& folder, const Registry& registry,
                                    const std::string& dataset) {
  try {
    return find(folder, registry, dataset);
  } catch (const Error& error) {
    throw UsageError(error.message());  // whatever stands in the way, no image has been opened
  }
}

SceneFiles find_scene(const std::string& folder, const Registry& registry, const std::string& name,
                      const std::string& dataset) {
  const std::vector<SceneFiles> scenes = find_scenes(folder, registry, dataset);
  if (name.empty() && scenes.size() == 1) return scenes.front();
  const fs::path path = fs::absolute(folder).lexically_normal();
  const std::string own = (path.has_filename() ? path : path.parent_path()).filename().string();
  std::vector<std::string> names;
  for (const SceneFiles& scene : scenes) {
    if (scene.name == (name.empty() ? own : name)) return scene;
    names.push_back(scene.name);
  }
  if (name.empty()) {
    throw UsageError(folder + ": holds " + std::to_string(names.size()) +
                     " scenes; choose one with --scene NAME: " + join(names));
  }
  throw UsageError(folder + ": has no scene '" + name + "'; " + suggest(name, names, "scenes"));
}

}  // namespace xgm
