// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/bench/surface_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "xgm/base/error.hpp"

namespace xgm::geo {
namespace {

namespace fs = std::filesystem;
constexpr const char* kSceneFile = "scene.yaml";

/// The name of a folder, whatever it is written like.
std::string name_of(const fs::path& folder) {
  const fs::path whole = fs::weakly_canonical(folder);
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

SurfaceScene read_scene(const fs::path& folder, const std::string& set) {
  const std::string file = (folder / kSceneFile).string();
  SurfaceScene scene{set, name_of(folder), read_surface_scene(file)};
  const auto refuse = [&](const std::string& what) { throw UsageError(file + ": " + what); };
  const SurfaceFiles& files = scene.files;
  if (files.images.size() < 2) refuse("'images' needs at least two files");
  if (files.truth.empty()) refuse("'truth' is missing: the raster of true heights");
  if (!files.visible.empty() && files.visible.size() != files.images.size()) {
    refuse("'visible' needs one file for each of the images, or none");
  }
  return scene;
}

/// Of files that there is one of for each image, or none.
void keep(std::vector<std::string>& files, std::size_t i, std::size_t j) {
  if (!files.empty()) files = {files.at(i), files.at(j)};
}

}  // namespace

std::vector<SurfaceScene> find_surface_scenes(const std::string& folder) {
  const fs::path path(folder);
  if (!fs::is_directory(path)) throw UsageError(folder + ": is no folder");
  if (fs::exists(path / kSceneFile)) {
    return {read_scene(path, name_of(fs::weakly_canonical(path).parent_path()))};
  }
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(path)) {
    if (fs::exists(entry.path() / kSceneFile)) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  if (folders.empty()) {
    throw UsageError(folder +
                     ": holds no satellite scene, that is no folder with a scene.yaml "
                     "('pipeline synth --satellite' makes some)");
  }
  std::vector<SurfaceScene> scenes;
  for (const fs::path& scene : folders) scenes.push_back(read_scene(scene, name_of(path)));
  return scenes;
}

std::vector<SurfaceScene> pairs_of(const SurfaceScene& scene) {
  std::vector<SurfaceScene> pairs;
  const std::size_t count = scene.files.images.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      SurfaceScene& pair = pairs.emplace_back(scene);
      pair.name += "_" + std::to_string(i + 1) + "_" + std::to_string(j + 1);
      SurfaceFiles& files = pair.files;
      for (auto* each : {&files.images, &files.masks, &files.cameras, &files.visible}) {
        keep(*each, i, j);
      }
    }
  }
  return pairs;
}

Raster judged_truth(const SurfaceScene& scene) {
  Raster truth = read_raster(scene.files.truth);
  if (scene.files.visible.empty()) return truth;
  cv::Mat1i images(truth.values.size(), 0);
  for (const std::string& file : scene.files.visible) {
    const Raster visible = read_raster(file);
    if (visible.values.size() != truth.values.size())
      throw Error(file + ": is not on the grid of " + scene.files.truth);
    const cv::Mat shown = (visible.values > 0) / 255;
    cv::add(images, shown, images, cv::noArray(), CV_32S);
  }
  truth.values.setTo(std::numeric_limits<float>::quiet_NaN(), images < 2);
  return truth;
}

}  // namespace xgm::geo
