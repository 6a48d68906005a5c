// SPDX-License-Identifier: Apache-2.0
// KITTI's stereo benchmarks of 2012 and 2015: one folder per kind of file, one file per scene.
#include <map>
#include <optional>

#include "plugins/dataset/file_layouts/faults.hpp"
#include "plugins/dataset/file_layouts/listing.hpp"
#include "plugins/dataset/kitti/projection.hpp"
#include "xgm/base/file_names.hpp"
#include "xgm/plugin.hpp"

namespace {

using namespace xgm;
using dataset::Listing;

enum class Colours { any, grey, colour };

/// Where a year's files lie.
struct Layout {
  const char* left;
  const char* right;
  int left_camera, right_camera;
  const char* occluded;  // truth, hidden pixels included
  const char* visible;   // truth without them
  const char* objects;   // nullptr: the year has none
  const char* calibration;
  Colours colours;
};

constexpr Layout kLayouts[] = {
    {"image_2", "image_3", 2, 3, "disp_occ_0", "disp_noc_0", "obj_map", "calib_cam_to_cam",
     Colours::colour},
    {"image_0", "image_1", 0, 1, "disp_occ", "disp_noc", nullptr, "calib", Colours::grey},
    {"colored_0", "colored_1", 2, 3, "disp_occ", "disp_noc", nullptr, "calib", Colours::colour},
};

constexpr const char* kFrame = "_10.png";  // the frame of each sequence that has truth

bool has(const Listing& folder, const Layout& layout) {
  return !folder.folder(layout.left).empty() && !folder.folder(layout.right).empty();
}

std::optional<Layout> layout_of(const Listing& folder, Colours wanted) {
  for (const Layout& layout : kLayouts) {
    const bool fits = wanted == Colours::any || wanted == layout.colours;
    if (fits && has(folder, layout)) return layout;
  }
  return std::nullopt;
}

/// A folder's files; none if there is no such folder.
class Part {
 public:
  Part(const Listing& top, const char* name) {
    const std::string path = name == nullptr ? "" : top.folder(name);
    if (!path.empty()) listing_.emplace(path);
  }
  std::string file(const std::string& name) const { return listing_ ? listing_->file(name) : ""; }

 private:
  std::optional<Listing> listing_;
};

class Kitti final : public Dataset {
 public:
  struct Parameters {
    Colours colours = Colours::any;
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add_choice("images", p.colours,
                   "Which cameras, where there are both kinds (2012); any takes the grey ones.",
                   {{"any", Colours::any}, {"grey", Colours::grey}, {"colour", Colours::colour}});
  }
  explicit Kitti(Parameters p) : p_(p) {}

  std::string layout() const override {
    return "image_2 and image_3, image_0 and image_1, or colored_0 and colored_1 with frames "
           "called *_10.png";
  }

  std::vector<SceneFiles> scenes(const std::string& folder) const override {
    Listing top(folder);
    std::optional<Layout> layout = layout_of(top, p_.colours);
    if (!layout && !top.folder("training").empty()) {  // the folder that both archives unpack to
      top = Listing(top.folder("training"));
      layout = layout_of(top, p_.colours);
    }
    return layout ? scenes(top, *layout) : std::vector<SceneFiles>();
  }

 private:
  static std::vector<SceneFiles> scenes(const Listing& top, const Layout& layout) {
    const Listing left(top.folder(layout.left)), right(top.folder(layout.right));
    const Part occluded(top, layout.occluded), visible(top, layout.visible),
        objects(top, layout.objects), calibration(top, layout.calibration);
    std::vector<SceneFiles> found;
    for (const auto& [frame, name] : frames(left, right)) {
      SceneFiles& scene = found.emplace_back();
      scene.name = frame;
      scene.images.left = file_or(left, name);
      scene.images.right = file_or(right, name);
      scene.truth.disparity = {occluded.file(name), kValuesPerPixel};
      scene.truth.visible = {visible.file(name), kValuesPerPixel};
      scene.truth.objects = objects.file(name);
      scene.disparities = kDisparities;
      add_cameras(scene, calibration.file(frame.substr(0, frame.rfind('_')) + ".txt"), layout);
      tell_missing(scene, layout);
    }
    return found;
  }

  /// Names of scenes and their files: a frame of which one image is there lacks the other.
  static std::map<std::string, std::string> frames(const Listing& left, const Listing& right) {
    std::map<std::string, std::string> names;
    for (const Listing* folder : {&left, &right}) {
      for (const std::string& name : folder->files()) {
        if (!lower_case(name).ends_with(kFrame)) continue;
        const std::string frame = name.substr(0, name.rfind('.'));
        if (name.ends_with(kFrame)) names[frame] = name;
        names.emplace(frame, name);
      }
    }
    return names;
  }

  static std::string file_or(const Listing& folder, const std::string& name) {
    const std::string file = folder.file(name);
    return file.empty() ? folder.path() + "/" + name : file;
  }

  static void add_cameras(SceneFiles& scene, const std::string& file, const Layout& layout) {
    if (file.empty()) return;
    scene.calibration_file = file;
    dataset::note_fault(scene, file, [&] {
      const auto cameras = kitti::read_cameras(file, layout.left_camera, layout.right_camera);
      scene.calibration = cameras.calibration;
      scene.calibrated_size = cameras.size;
    });
  }

  static void tell_missing(SceneFiles& scene, const Layout& layout) {
    const auto lacks = [&](const std::string& file, const char* folder, const char* purpose) {
      if (file.empty())
        scene.missing.push_back("a file in " + std::string(folder) + ": " + purpose);
    };
    lacks(scene.truth.disparity.file, layout.occluded,
          "true disparities to judge by (the test scenes have none)");
    lacks(scene.truth.visible.file, layout.visible, "which pixels are not occluded");
    if (layout.objects != nullptr) {
      lacks(scene.truth.objects, layout.objects, "which pixels are of moving objects (foreground)");
    }
    lacks(scene.calibration_file, layout.calibration,
          "the cameras, by which disparities become depths (an archive of its own)");
  }

  static constexpr double kValuesPerPixel = 256;
  static constexpr Interval kDisparities{0, 256};  // what such a file can hold

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Kitti>("kitti",
                      "KITTI stereo 2012 and 2015: the folder training or testing of the archives.",
                      "Geiger et al., Are we ready for autonomous driving?, CVPR 2012; Menze and "
                      "Geiger, Object scene flow for autonomous vehicles, CVPR 2015");
}
