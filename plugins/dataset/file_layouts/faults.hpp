// SPDX-License-Identifier: Apache-2.0
// What is wrong with a file of one scene is that scene's: the others are listed as ever.
#pragma once

#include <string>

#include "xgm/base/error.hpp"
#include "xgm/data/scene_files.hpp"

namespace xgm::dataset {

/// Calls `read`, which reads `file`; its Error becomes a fault of the scene.
template <class Read>
void note_fault(SceneFiles& scene, const std::string& file, Read read) {
  try {
    read();
  } catch (const Error& error) {
    scene.faults.push_back({file, error.message()});
  }
}

}  // namespace xgm::dataset
