// SPDX-License-Identifier: Apache-2.0
// Middlebury's scenes of 2001 and 2003. Truth is 8 bit; what a grey level means depends on the
// scene.
#include <cmath>

#include "plugins/dataset/file_layouts/folders.hpp"
#include "plugins/dataset/file_layouts/middlebury_layout.hpp"
#include "xgm/plugin.hpp"

namespace {

using namespace xgm;
using dataset::Listing;

/// Grey levels per px. 2001: 8. 2003 (cones, teddy): 4 in quarter size, the one that most people
/// have, 2 in half and 1 in full size, told by the last letter.
double divisor_of(const std::string& scene) {
  if (!scene.starts_with("cones") && !scene.starts_with("teddy")) return 8;
  return scene.ends_with('F') ? 1 : scene.ends_with('H') ? 2 : 4;
}

class Middlebury2001 final : public Dataset {
 public:
  struct Parameters {
    double divisor = 0;
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add("divisor", p.divisor,
            "Grey levels of the truth per px of disparity; 0: by the scene's name (tsukuba 16, "
            "cones and teddy 4, conesH and teddyH 2, conesF and teddyF 1, others 8).")
        .unit("1/px")
        .range(0, 256);
    set.rule({"divisor"}, "must be 0, or 1 or more",
             [&p] { return p.divisor == 0 || p.divisor >= 1; });
  }
  explicit Middlebury2001(Parameters p) : p_(p) {}

  std::string layout() const override {
    return "im2 and im6 (map: im0, im1 and disp0.pgm; tsukuba: scene1.row3.col3 and col4)";
  }

  std::vector<SceneFiles> scenes(const std::string& folder) const override {
    return dataset::scenes_of(
        dataset::scene_folders(folder, dataset::is_middlebury_2001),
        [this](const Listing& inner, auto& found) { found.push_back(scene_in(inner)); });
  }

 private:
  SceneFiles scene_in(const Listing& folder) const {
    SceneFiles scene;
    scene.name = dataset::name_of(folder.path());
    double divisor = divisor_of(scene.name);
    if (dataset::is_tsukuba(folder)) {
      divisor = 16;
      scene.images.left = dataset::image_or(folder, "scene1.row3.col3", ".ppm");
      scene.images.right = dataset::image_or(folder, "scene1.row3.col4", ".ppm");
      scene.truth.disparity.file = folder.image("truedisp.row3.col3");
    } else {
      const bool is_map = dataset::is_map(folder);
      scene.images.left = dataset::image_or(folder, is_map ? "im0" : "im2", ".ppm");
      scene.images.right = dataset::image_or(folder, is_map ? "im1" : "im6", ".ppm");
      scene.truth.disparity.file = folder.image(is_map ? "disp0" : "disp2");
      scene.truth.reverse.file = folder.image(is_map ? "disp1" : "disp6");
    }
    if (p_.divisor > 0) divisor = p_.divisor;
    scene.truth.disparity.divisor = divisor;
    scene.truth.reverse.divisor = -divisor;
    constexpr double kLevels = 256;  // no disparity of the set is above what 8 bit can say
    scene.disparities = Interval{0, static_cast<int>(std::ceil(kLevels / divisor))};
    if (scene.truth.disparity.file.empty()) {
      scene.missing.push_back("disp2 (.pgm or .png): true disparities to judge by");
    } else if (scene.truth.reverse.file.empty()) {
      scene.missing.push_back(
          "truth of the right view (disp6): which pixels are not occluded is not known");
    }
    return scene;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Middlebury2001>(
      "middlebury_2001", "Middlebury scenes of 2001 and 2003: folders that hold im2 and im6.",
      "Scharstein and Szeliski, A taxonomy and evaluation of dense two-frame stereo correspondence "
      "algorithms, IJCV 2002; High-accuracy stereo depth maps using structured light, CVPR 2003");
}
