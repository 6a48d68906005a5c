// SPDX-License-Identifier: Apache-2.0
// A folder that is a scene, or holds scenes directly.
#pragma once

#include <functional>
#include <vector>

#include "plugins/dataset/file_layouts/listing.hpp"

namespace xgm::dataset {

/// `folder` alone if it is a scene, else those directly in it that are.
std::vector<Listing> scene_folders(const std::string& folder,
                                   const std::function<bool(const Listing&)>& is_scene);

}  // namespace xgm::dataset
