// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/evaluation/surface_scene.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "xgm/base/error.hpp"
#include "xgm/geo/ground/dem.hpp"
#include "xgm/io/file.hpp"

namespace xgm::geo {
namespace {

namespace fs = std::filesystem;
constexpr const char* kSceneFile = "scene.yaml";

[[noreturn]] void refuse(const std::string& file, const YAML::Mark& mark, const std::string& what) {
  const std::string place = mark.is_null() ? "" : ":" + std::to_string(mark.line + 1);
  throw UsageError(file + place + ": " + what);
}

/// The files of a scene, as it names them.
class SceneFile {
 public:
  explicit SceneFile(const std::string& file) : file_(file) {
    try {
      root_ = YAML::Load(read_file(file));
    } catch (const YAML::ParserException& error) {
      refuse(file, error.mark, "is no YAML: " + error.msg);
    }
    if (!root_.IsMap()) refuse(file, root_.Mark(), "is no map; write 'images: [...]' and 'truth:'");
  }

  std::vector<std::string> list(const std::string& key) const {
    std::vector<std::string> files;
    const YAML::Node node = root_[key];
    if (!node) return files;
    if (!node.IsSequence()) refuse(file_, node.Mark(), "'" + key + "' is a list of files");
    for (const YAML::Node& item : node) files.push_back(path(item, key));
    return files;
  }

  std::string one(const std::string& key) const {
    const YAML::Node node = root_[key];
    return node ? path(node, key) : std::string();
  }

  void refuse_as_whole(const std::string& what) const { refuse(file_, root_.Mark(), what); }

 private:
  std::string path(const YAML::Node& node, const std::string& key) const {
    if (!node.IsScalar()) refuse(file_, node.Mark(), "'" + key + "' needs the name of a file");
    const std::string file = (fs::path(file_).parent_path() / node.Scalar()).string();
    if (!fs::is_regular_file(dem_files({file}).front()))
      refuse(file_, node.Mark(), file + " does not exist; correct '" + key + "'");
    return file;
  }

  std::string file_;
  YAML::Node root_;
};

/// The name of a folder, whatever it is written like.
std::string name_of(const fs::path& folder) {
  const fs::path whole = fs::weakly_canonical(folder);
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

SurfaceScene read_scene(const fs::path& folder, const std::string& set) {
  const SceneFile file((folder / kSceneFile).string());
  SurfaceScene scene{.set = set, .name = name_of(folder), .images = file.list("images")};
  scene.dem = file.one("dem");
  scene.truth = file.one("truth");
  scene.visible = file.list("visible");
  if (scene.images.size() < 2) file.refuse_as_whole("'images' needs at least two files");
  if (scene.truth.empty()) file.refuse_as_whole("'truth' is missing: the raster of true heights");
  if (!scene.visible.empty() && scene.visible.size() != scene.images.size()) {
    file.refuse_as_whole("'visible' needs one file for each of the images, or none");
  }
  return scene;
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
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.images.size(); ++j) {
      SurfaceScene& pair = pairs.emplace_back(scene);
      pair.name += "_" + std::to_string(i + 1) + "_" + std::to_string(j + 1);
      pair.images = {scene.images[i], scene.images[j]};
      if (!scene.visible.empty()) pair.visible = {scene.visible[i], scene.visible[j]};
    }
  }
  return pairs;
}

Raster judged_truth(const SurfaceScene& scene) {
  Raster truth = read_raster(scene.truth);
  if (scene.visible.empty()) return truth;
  cv::Mat1i images(truth.values.size(), 0);
  for (const std::string& file : scene.visible) {
    const Raster visible = read_raster(file);
    if (visible.values.size() != truth.values.size())
      throw Error(file + ": is not on the grid of " + scene.truth);
    const cv::Mat shown = (visible.values > 0) / 255;
    cv::add(images, shown, images, cv::noArray(), CV_32S);
  }
  truth.values.setTo(std::numeric_limits<float>::quiet_NaN(), images < 2);
  return truth;
}

}  // namespace xgm::geo
