// SPDX-License-Identifier: Apache-2.0
// Middlebury's evaluation version 3 and its 2014 set; any folder with im0 and im1.
#include "plugins/dataset/file_layouts/calib_txt.hpp"
#include "plugins/dataset/file_layouts/middlebury_layout.hpp"
#include "plugins/dataset/middlebury_v3/benchmark.hpp"
#include "xgm/plugin.hpp"

namespace {

using namespace xgm;
using namespace xgm::middlebury_v3;
using dataset::Listing;

/// "Piano-perfect" is the scene Piano with the best rectification that the 2014 set has of it.
struct Name {
  std::string scene;
  std::string rectification;  ///< "-perfect", "-imperfect" or none

  explicit Name(const std::string& folder) : scene(folder) {
    for (const std::string ending : {"-perfect", "-imperfect"}) {
      if (!folder.ends_with(ending)) continue;
      scene = folder.substr(0, folder.size() - ending.size());
      rectification = ending;
    }
  }
};

SceneFiles scene_in(const Listing& folder) {
  const Name name(dataset::name_of(folder.path()));
  SceneFiles scene;
  scene.name = name.scene + name.rectification;
  dataset::add_images(scene, folder);
  dataset::add_calib_txt(scene, folder.file("calib.txt"));
  dataset::add_truth(scene, folder);
  const double scale = scale_of_folder(dataset::name_of(dataset::parent_of(folder.path())));
  if (scale > 0) {
    scene.scale = scale;
  } else if (!folder.file("disp0GT.pfm").empty()) {  // not so the 2014 set: it is of full size
    scene.scale = scale_of_width(scene.name, scene.calibrated_size.width);
  }
  scene.weight = weight(scene.name);
  return scene;
}

class MiddleburyV3 final : public Dataset {
 public:
  struct Parameters {};
  static void describe(Parameters&, ParameterSet&) {}
  explicit MiddleburyV3(Parameters) {}

  std::string layout() const override { return "im0 and im1"; }

  std::vector<SceneFiles> scenes(const std::string& folder) const override {
    const dataset::SceneFolders folders = dataset::pair_folders(folder);
    if (dataset::are_eth3d(folders.scenes)) return {};
    return dataset::scenes_of(folders, add_scenes);
  }

 private:
  static void add_scenes(const Listing& folder, std::vector<SceneFiles>& found) {
    found.push_back(scene_in(folder));
    add_variants(folder, found);
  }

  /// The right image under another exposure or lighting makes another scene of the same truth.
  static void add_variants(const Listing& folder, std::vector<SceneFiles>& found) {
    const SceneFiles plain = found.back();
    const Name name(dataset::name_of(folder.path()));
    for (const std::string variant : {"E", "L"}) {
      const std::string right = folder.image("im1" + variant);
      if (right.empty()) continue;
      SceneFiles& scene = found.emplace_back(plain);
      scene.name = name.scene + variant + name.rectification;
      scene.images.right = right;
    }
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MiddleburyV3>(
      "middlebury_v3",
      "Middlebury evaluation version 3 and 2014 set, and any folder that holds im0 and im1.",
      "Scharstein et al., High-resolution stereo datasets with subpixel-accurate ground truth, "
      "GCPR 2014");
}
