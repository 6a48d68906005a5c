// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/file_layouts/folders.hpp"

namespace xgm::dataset {

std::vector<Listing> scene_folders(const std::string& folder,
                                   const std::function<bool(const Listing&)>& is_scene) {
  const Listing top(folder);
  if (is_scene(top)) return {top};
  std::vector<Listing> found;
  for (const std::string& name : top.folders()) {
    Listing inner(top.folder(name));
    if (is_scene(inner)) found.push_back(std::move(inner));
  }
  return found;
}

}  // namespace xgm::dataset
