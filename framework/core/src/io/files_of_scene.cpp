// SPDX-License-Identifier: Apache-2.0
// The files of a scene and their roles, as the record and messages call them.
#include "xgm/io/scene.hpp"

namespace xgm {
namespace {

std::vector<NamedFile> existing(std::vector<NamedFile> files) {
  std::erase_if(files, [](const NamedFile& file) { return file.file.empty(); });
  return files;
}

}  // namespace

std::vector<NamedFile> files_of(const SceneFiles& scene) {
  return existing({{"left", scene.images.left},
                   {"right", scene.images.right},
                   {"left mask", scene.images.left_mask},
                   {"right mask", scene.images.right_mask},
                   {"calibration", scene.calibration_file}});
}

std::vector<NamedFile> files_of(const TruthFiles& truth) {
  return existing({{"truth", truth.disparity.file},
                   {"reverse truth", truth.reverse.file},
                   {"truth of visible pixels", truth.visible.file},
                   {"truth mask", truth.non_occluded},
                   {"object map", truth.objects}});
}

std::vector<InputFile> identify_files(const std::vector<NamedFile>& files) {
  std::vector<InputFile> inputs;
  for (const auto& [role, file] : files) inputs.push_back({role, file, identify_file(file)});
  return inputs;
}

}  // namespace xgm
