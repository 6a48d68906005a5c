// SPDX-License-Identifier: Apache-2.0
// Middlebury's scenes of 2005 and 2006, in full, half and third size.
#include <array>
#include <fstream>

#include "plugins/dataset/file_layouts/faults.hpp"
#include "plugins/dataset/file_layouts/folders.hpp"
#include "plugins/dataset/file_layouts/text_file.hpp"
#include "xgm/plugin.hpp"

namespace {

using namespace xgm;
using dataset::Listing;

// All that the set's page says of the cameras, in full size; they are not turned to each other.
constexpr double kFocal = 3740;    // px
constexpr double kBaseline = 160;  // mm, between view1 and view5

struct Size {
  int width = 0, height = 0;
};

/// Width and height as a PNG's first chunk has them; 0 if this is no PNG.
Size png_size(const std::string& file) {
  std::array<unsigned char, 24> head{};
  std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(head.data()), head.size());
  if (head[1] != 'P' || head[2] != 'N' || head[3] != 'G') return {};
  const auto number = [&](std::size_t i) {
    return head[i] << 24 | head[i + 1] << 16 | head[i + 2] << 8 | head[i + 3];
  };
  return {number(16), number(20)};
}

/// 1, 2 or 3 by the folder that holds the scene, else by the height, which all scenes of one size
/// share; 0 if neither tells.
int size_divisor(const std::string& scene_folder, int height) {
  const std::string parent = dataset::name_of(dataset::parent_of(scene_folder));
  if (parent.ends_with("FullSize") || height == 1110) return 1;
  if (parent.ends_with("HalfSize") || height == 555) return 2;
  if (parent.ends_with("ThirdSize") || height == 370) return 3;
  return 0;
}

double read_dmin(const std::string& file) {
  const std::vector<dataset::Line> lines = dataset::read_lines(file);
  if (lines.size() != 1) throw Error(file + ": must hold one number; take the data set's own file");
  return dataset::to_number(lines[0].text, lines[0].place, "dmin");
}

/// Half a pair is a scene that lacks the other half, if something else tells what it is.
bool is_scene(const Listing& folder) {
  const auto has = [&](const char* stem) { return !folder.image(stem).empty(); };
  const bool is_of_set = has("disp1") || has("disp5") || !folder.file("dmin.txt").empty();
  return (has("view1") && has("view5")) || (is_of_set && (has("view1") || has("view5")));
}

class Middlebury2005 final : public Dataset {
 public:
  struct Parameters {
    int divisor = 0;
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add("divisor", p.divisor,
            "How many times smaller than full size the images are: 1, 2 or 3; 0: by the folder's "
            "name (FullSize, HalfSize, ThirdSize), else by the height of the images.")
        .range(0, 3);
  }
  explicit Middlebury2005(Parameters p) : p_(p) {}

  std::string layout() const override { return "view1 and view5"; }

  std::vector<SceneFiles> scenes(const std::string& folder) const override {
    return dataset::scenes_of(
        dataset::scene_folders(folder, is_scene),
        [this](const Listing& inner, auto& found) { found.push_back(scene_in(inner)); });
  }

 private:
  SceneFiles scene_in(const Listing& folder) const {
    SceneFiles scene;
    scene.name = dataset::name_of(folder.path());
    scene.images.left = dataset::image_or(folder, "view1", ".png");
    scene.images.right = dataset::image_or(folder, "view5", ".png");
    const Size size = png_size(scene.images.left);
    const int divisor = p_.divisor > 0 ? p_.divisor : size_divisor(folder.path(), size.height);
    if (divisor == 0) {
      scene.missing.push_back(
          "the size (full, half or third), without which the truth has no unit: name the folder of "
          "the scenes FullSize, HalfSize or ThirdSize");
      return scene;
    }
    scene.scale = divisor;
    constexpr int kLevels = 256;  // disparities in full size are stored in 8 bit
    scene.disparities = Interval{0, (kLevels + divisor - 1) / divisor};
    add_truth(scene, folder, divisor);
    add_calibration(scene, folder, divisor, size);
    return scene;
  }

  static void add_truth(SceneFiles& scene, const Listing& folder, double divisor) {
    scene.truth.disparity = {folder.image("disp1"), divisor};
    scene.truth.reverse = {folder.image("disp5"), -divisor};
    if (scene.truth.disparity.file.empty()) {
      scene.missing.push_back("disp1.png: true disparities to judge by");
    } else if (scene.truth.reverse.file.empty()) {
      scene.missing.push_back("disp5.png, to derive from it which pixels are not occluded");
    }
  }

  /// Views are cropped: dmin px of full size, in every size, were taken off the disparities. The
  /// principal point is not published; the image's centre stands in for it, which shifts clouds
  /// sideways but no depth.
  static void add_calibration(SceneFiles& scene, const Listing& folder, double divisor, Size size) {
    const std::string file = folder.file("dmin.txt");
    if (file.empty()) {
      scene.missing.push_back(
          "dmin.txt: how far the views are cropped, without which disparities are no depths");
      return;
    }
    if (size.width <= 0) {
      scene.missing.push_back("view1 as PNG: the size of the image, where the cameras are centred");
      return;
    }
    scene.calibration_file = file;
    dataset::note_fault(scene, file, [&] {
      scene.calibration =
          Calibration{kFocal / divisor, (size.width - 1) / 2.0, (size.height - 1) / 2.0,
                      read_dmin(file) / divisor, kBaseline};
    });
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Middlebury2005>(
      "middlebury_2005", "Middlebury scenes of 2005 and 2006: folders that hold view1 and view5.",
      "Scharstein and Pal, Learning conditional random fields for stereo, CVPR 2007; Hirschmueller "
      "and Scharstein, Evaluation of cost functions for stereo matching, CVPR 2007");
}
