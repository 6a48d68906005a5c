// SPDX-License-Identifier: Apache-2.0
// ETH3D's low-resolution two-view scenes. Laid out as Middlebury's; known by the scenes' names.
#include "plugins/dataset/file_layouts/calib_txt.hpp"
#include "plugins/dataset/file_layouts/middlebury_layout.hpp"
#include "xgm/plugin.hpp"

namespace {

using namespace xgm;
using dataset::Listing;

class Eth3d final : public Dataset {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit Eth3d(Parameters) {}

  std::string layout() const override {
    return "im0 and im1 in folders called like playground_1l or forest_2s";
  }

  std::vector<SceneFiles> scenes(const std::string& folder) const override {
    const dataset::SceneFolders folders = dataset::pair_folders(folder);
    if (!dataset::are_eth3d(folders.scenes)) return {};
    return dataset::scenes_of(folders, add_scene);
  }

 private:
  static void add_scene(const Listing& folder, std::vector<SceneFiles>& found) {
    SceneFiles& scene = found.emplace_back();
    scene.name = dataset::name_of(folder.path());
    dataset::add_images(scene, folder);
    dataset::add_calib_txt(scene, folder.file("calib.txt"));
    dataset::add_truth(scene, folder);
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Eth3d>(
      "eth3d", "ETH3D low-resolution two-view scenes, images and truth unpacked into one folder.",
      "Schoeps et al., A multi-view stereo benchmark with high-resolution images and multi-camera "
      "videos, CVPR 2017");
}
