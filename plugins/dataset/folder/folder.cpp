// SPDX-License-Identifier: Apache-2.0
// People's own data, described by patterns of paths.
#include <cmath>
#include <filesystem>

#include "plugins/dataset/file_layouts/calib_txt.hpp"
#include "plugins/dataset/file_layouts/listing.hpp"
#include "plugins/dataset/folder/pattern.hpp"
#include "xgm/base/file_names.hpp"
#include "xgm/plugin.hpp"

namespace {

using namespace xgm;

constexpr double kMax = 1e6;
constexpr double kMin = 1e-6;

struct FolderParameters {
  std::string left, right, left_mask, right_mask;
  std::string truth, reverse_truth, visible_truth, non_occluded, objects;
  double truth_divisor = 0, reverse_truth_divisor = 0;  // 0 = not said
  std::string calibration;
  std::vector<double> disparities;
  double weight = 1, scale = 1;
};

/// Whether there is something of that name, be it that it cannot be read.
bool is_there(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code unusable;
  const fs::file_status status = fs::symlink_status(file, unusable);
  return unusable ? unusable == std::errc::permission_denied : !fs::is_directory(status);
}

void describe_images(FolderParameters& p, ParameterSet& set) {
  set.add("left", p.left,
          "Left images: a path below the data folder, '{scene}' standing for the name of a scene, "
          "for example '{scene}/left.tif' or 'left/{scene}.png'; without '{scene}' the folder is "
          "one scene.");
  set.add("right", p.right, "Right images, likewise.");
  set.add("left_mask", p.left_mask, "Masks that are not zero where a left image may be used.");
  set.add("right_mask", p.right_mask, "The same of the right images.");
}

void describe_truth(FolderParameters& p, ParameterSet& set) {
  set.add("truth", p.truth,
          "True disparities of the left images: PFM (not finite = none), or images of 8 or 16 bit "
          "(0 = none).");
  set.add("truth_divisor", p.truth_divisor,
          "What the values of truth and visible_truth are divided by to give px, negative if they "
          "have the other sign than x_left - x_right; images of 8 or 16 bit need it, 0 = not said.")
      .range(-kMax, kMax);
  set.add("reverse_truth", p.reverse_truth, "True disparities of the right images.");
  set.add("reverse_truth_divisor", p.reverse_truth_divisor,
          "What their values are divided by to give px, negative if they are stored as positive "
          "numbers; images of 8 or 16 bit need it, 0 = not said: PFM is divided by -1.")
      .range(-kMax, kMax);
  set.add("visible_truth", p.visible_truth,
          "The truth of the left images without pixels that are hidden in the right ones.");
  set.add("non_occluded", p.non_occluded,
          "Masks that are 255 where a left pixel is seen in the right image, too; without them "
          "they are made from visible_truth or reverse_truth.");
  set.add("objects", p.objects, "Maps that are not zero on moving objects, judged on their own.");
}

void require_placeholders(FolderParameters& p, ParameterSet& set) {
  const auto require = [&set](const char* name, const std::string& pattern) {
    set.rule({name}, "must have no unknown placeholder; did you mean {scene}?",
             [&pattern] { return !folder::has_unknown_placeholder(pattern); });
  };
  require("left", p.left);
  require("right", p.right);
  require("left_mask", p.left_mask);
  require("right_mask", p.right_mask);
  require("truth", p.truth);
  require("reverse_truth", p.reverse_truth);
  require("visible_truth", p.visible_truth);
  require("non_occluded", p.non_occluded);
  require("objects", p.objects);
  require("calibration", p.calibration);
}

class Folder final : public Dataset {
 public:
  using Parameters = FolderParameters;
  static void describe(Parameters& p, ParameterSet& set) {
    describe_images(p, set);
    describe_truth(p, set);
    set.add("calibration", p.calibration, "Cameras and ndisp, in Middlebury's format (calib.txt).");
    set.add("disparities", p.disparities,
            "Range to search [first, last], both included; without it ndisp of the calibration.")
        .unit("px")
        .range(-kMax, kMax);
    set.add("weight", p.weight, "Weight of each scene in averages.").range(kMin, kMax);
    set.add("scale", p.scale,
            "One pixel is so many of the resolution that errors are to be judged in.")
        .range(kMin, kMax);
    require_placeholders(p, set);
    const auto given = "must be given: a path such as '{scene}/left.png'";
    set.rule({"left"}, given, [&p] { return !p.left.empty(); });
    set.rule({"right"}, given, [&p] { return !p.right.empty(); });
    set.rule({"right", "left"}, "must have '{scene}' if left has it, and only then", [&p] {
      return p.left.empty() || p.right.empty() ||
             folder::has_gap(p.left) == folder::has_gap(p.right);
    });
    set.rule({"disparities"}, "must be two whole numbers, the first not above the second", [&p] {
      const auto& d = p.disparities;
      const auto whole = [](double v) { return v == std::floor(v); };
      return d.empty() || (d.size() == 2 && whole(d[0]) && whole(d[1]) && d[0] <= d[1]);
    });
  }
  explicit Folder(Parameters p) : p_(std::move(p)) {}

  std::string layout() const override { return p_.left + " and " + p_.right; }

  std::vector<SceneFiles> scenes(const std::string& folder) const override {
    const dataset::Listing readable(folder);
    const auto is_scene = [&](const std::string& name) {
      return is_there(path_of(p_.left, name, folder)) || is_there(path_of(p_.right, name, folder));
    };
    std::vector<SceneFiles> found;
    if (!folder::has_gap(p_.left)) {
      if (is_scene("")) found.push_back(scene(folder, dataset::name_of(folder)));
      return found;
    }
    for (const std::string& name : folder::names_that_fit(p_.left, folder)) {
      if (is_scene(name)) found.push_back(scene(folder, name));
    }
    return found;
  }

 private:
  static std::string path_of(const std::string& pattern, const std::string& name,
                             const std::string& top) {
    return find_path(folder::fill(pattern, name, top));
  }

  SceneFiles scene(const std::string& top, const std::string& name) const {
    SceneFiles scene;
    scene.name = name;
    scene.weight = p_.weight;
    scene.scale = p_.scale;
    const auto path = [&](const std::string& pattern) { return path_of(pattern, name, top); };
    const auto optional = [&](const std::string& pattern, const char* what) {
      const std::string file = path(pattern);
      if (file.empty() || is_there(file)) return file;
      scene.missing.push_back(file + ": " + what);
      return std::string();
    };
    scene.images = {path(p_.left), path(p_.right), path(p_.left_mask), path(p_.right_mask)};
    scene.truth.disparity = {optional(p_.truth, "true disparities to judge by"), p_.truth_divisor};
    scene.truth.reverse = {optional(p_.reverse_truth, "true disparities of the right view"),
                           p_.reverse_truth_divisor};
    scene.truth.visible = {optional(p_.visible_truth, "true disparities of pixels not hidden"),
                           p_.truth_divisor};
    scene.truth.non_occluded = optional(p_.non_occluded, "which pixels are not occluded");
    scene.truth.objects = optional(p_.objects, "which pixels are of moving objects");
    if (!p_.calibration.empty()) {
      dataset::add_calib_txt(scene, optional(p_.calibration, "the cameras"));
    }
    if (!p_.disparities.empty()) {
      scene.disparities =
          Interval{static_cast<int>(p_.disparities[0]), static_cast<int>(p_.disparities[1]) + 1};
      scene.disparities_file.clear();
    }
    return scene;
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<Folder>("folder", "Data of your own, described by patterns of paths.");
}
