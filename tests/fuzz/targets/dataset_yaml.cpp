// SPDX-License-Identifier: Apache-2.0
// A dataset.yaml in a folder that holds two scenes.
#include <filesystem>
#include <set>

#include "fuzz/support/pipelines.hpp"
#include "fuzz/support/target.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/scene.hpp"

namespace xgm::fuzz {
namespace {

/// Its images are empty, since nobody opens them.
class TwoScenes {
 public:
  TwoScenes() {
    for (const std::string scene : {"a", "b"}) {
      std::filesystem::create_directories(folder_ / scene);
      for (const std::string file : {"left.png", "right.png", "mask.png", "truth.pfm"}) {
        folder_.write(scene + "/" + file, "");
      }
    }
  }
  std::string path() const { return folder_.path(); }
  void describe(std::string_view text) const { folder_.write("dataset.yaml", std::string(text)); }

 private:
  testing::TemporaryFolder folder_;
};

}  // namespace

void check(std::string_view input) {
  static const TwoScenes folder;
  folder.describe(input);
  std::vector<SceneFiles> scenes;
  if (!accepts(folder.path(), [&] { scenes = find_scenes(folder.path(), builtins()); })) return;
  std::set<std::string> names;
  for (const SceneFiles& scene : scenes) {
    require(!scene.images.left.empty() && !scene.images.right.empty(), "a scene has two images");
    require(names.insert(scene.name).second, "no two scenes have one name");
    require(!scene.disparities || !scene.disparities->empty(), "there is a disparity to search");
    require(scene.weight > 0 && scene.scale > 0, "weight and scale are above 0");
  }
  require(!scenes.empty(), "there is a scene");
}

std::vector<std::string> seeds() {
  return {"{type: folder, left: '{scene}/left.png', right: '{scene}/right.png'}",
          "type: folder\nleft: a/left.png\nright: a/right.png\ndisparities: [-5, 60]\n",
          "type: folder\nleft: '{scene}/left.png'\nright: '{scene}/right.png'\n"
          "truth: '{scene}/truth.pfm'\ntruth_divisor: -1\nleft_mask: '{scene}/mask.png'\n"
          "weight: 2\nscale: 0.5\n",
          "kitti", "{type: kitti, images: grey}"};
}

std::vector<std::string> words() {
  std::vector<std::string> all = yaml_words();
  for (const char* word : {"{scene}", "left.png", "right.png", "a/", "*", "../"}) {
    all.emplace_back(word);
  }
  return all;
}

}  // namespace xgm::fuzz
