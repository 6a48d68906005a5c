// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/file_layouts/folders.hpp"

#include <algorithm>
#include <filesystem>

#include "xgm/base/error.hpp"

namespace xgm::dataset {
namespace fs = std::filesystem;

SceneFiles unreadable_scene(const std::string& name, const std::string& folder,
                            const std::string& message) {
  SceneFiles scene;
  scene.name = name;
  scene.faults.push_back({folder, message});
  return scene;
}

SceneFolders scene_folders(const std::string& folder,
                           const std::function<bool(const Listing&)>& is_scene) {
  const Listing top(folder);
  if (is_scene(top)) return {{top}, {}};
  SceneFolders found;
  for (const std::string& name : top.folders()) {
    const std::string path = (fs::path(folder) / name).string();
    try {
      Listing inner(path);
      if (is_scene(inner)) found.scenes.push_back(std::move(inner));
    } catch (const Error& error) {
      found.unreadable.push_back(unreadable_scene(name, path, error.message()));
    }
  }
  for (const std::string& name : top.dangling()) {
    if (fs::path(name).has_extension()) continue;  // would not be a folder
    const std::string path = (fs::path(folder) / name).string();
    found.unreadable.push_back(unreadable_scene(
        name, path, path + ": is a link that leads nowhere; mend the link, or remove it"));
  }
  // Where there is no scene beside them, nothing says that they were to be scenes.
  if (found.scenes.empty()) found.unreadable.clear();
  return found;
}

std::vector<SceneFiles> scenes_of(
    const SceneFolders& folders,
    const std::function<void(const Listing&, std::vector<SceneFiles>&)>& add) {
  std::vector<SceneFiles> found;
  for (const Listing& folder : folders.scenes) add(folder, found);
  found.insert(found.end(), folders.unreadable.begin(), folders.unreadable.end());
  std::sort(found.begin(), found.end(),
            [](const SceneFiles& a, const SceneFiles& b) { return a.name < b.name; });
  return found;
}

}  // namespace xgm::dataset
