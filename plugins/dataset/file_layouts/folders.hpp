// SPDX-License-Identifier: Apache-2.0
// A folder that is a scene, or holds scenes directly.
#pragma once

#include <functional>
#include <vector>

#include "plugins/dataset/file_layouts/listing.hpp"
#include "xgm/data/scene_files.hpp"

namespace xgm::dataset {

struct SceneFolders {
  std::vector<Listing> scenes;
  /// What lies beside them but cannot be listed, as scenes with that fault.
  std::vector<SceneFiles> unreadable;
};

/// `folder` alone if it is a scene, else those directly in it that are.
SceneFolders scene_folders(const std::string& folder,
                           const std::function<bool(const Listing&)>& is_scene);

/// The scenes that `add` makes of each folder, and those that cannot be read, sorted by name.
std::vector<SceneFiles> scenes_of(
    const SceneFolders& folders,
    const std::function<void(const Listing&, std::vector<SceneFiles>&)>& add);

/// A scene of which nothing is known but why its folder cannot be read.
SceneFiles unreadable_scene(const std::string& name, const std::string& folder,
                            const std::string& message);

}  // namespace xgm::dataset
