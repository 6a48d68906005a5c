// SPDX-License-Identifier: Apache-2.0
// The Freiburg SceneFlow sets (FlyingThings3D, Driving, Monkaa) as they are unpacked: the tree of
// images is repeated below disparity/.
#include <filesystem>
#include <functional>

#include "plugins/dataset/file_layouts/folders.hpp"
#include "xgm/base/file_names.hpp"
#include "xgm/plugin.hpp"

namespace {

using namespace xgm;
using dataset::Listing;
namespace fs = std::filesystem;

enum class Pass { clean, final };

constexpr const char* kFolders[] = {"frames_cleanpass", "frames_finalpass"};
constexpr const char* kNames[] = {"clean", "final"};

/// "TRAIN/A/0000", "0006" to "TRAIN_A_0000_0006": names may become names of files.
std::string scene_name(const fs::path& sequence, const std::string& frame) {
  std::string name;
  for (const fs::path& part : sequence) name += part.string() + "_";
  return name + frame;
}

/// Adds what `body(folder, path below the top)` finds in each folder that holds both views. One
/// that cannot be read is a scene with that fault.
void add_sequences(const std::string& path, const fs::path& below, std::vector<SceneFiles>& found,
                   const std::function<void(const Listing&, const fs::path&)>& body) {
  try {
    const Listing folder(path);
    if (!folder.folder("left").empty() && !folder.folder("right").empty()) body(folder, below);
    for (const std::string& name : folder.folders()) {
      if (lower_case(name) == "left" || lower_case(name) == "right") continue;
      add_sequences(folder.folder(name), below / name, found, body);
    }
  } catch (const Error& error) {
    found.push_back(dataset::unreadable_scene(below.generic_string(), path, error.message()));
  }
}

std::string file_if_there(const fs::path& path) {
  const std::string file = find_path(path.string());
  std::error_code unusable;
  return fs::exists(fs::symlink_status(file, unusable)) ? file : "";
}

class SceneFlow final : public Dataset {
 public:
  struct Parameters {
    Pass pass = Pass::clean;
  };
  static void describe(Parameters& p, ParameterSet& set) {
    set.add_choice("pass", p.pass, "Images without blur and haze (clean), or with them (final).",
                   {{"clean", Pass::clean}, {"final", Pass::final}});
  }
  explicit SceneFlow(Parameters p) : p_(p) {}

  std::string layout() const override {
    return "frames_cleanpass or frames_finalpass, and disparity";
  }

  std::vector<SceneFiles> scenes(const std::string& folder) const override {
    const Listing top(folder);
    const auto wanted = static_cast<std::size_t>(p_.pass);
    const std::string images = top.folder(kFolders[wanted]);
    std::vector<SceneFiles> found;
    if (images.empty()) {
      if (top.folder(kFolders[1 - wanted]).empty()) return found;
      throw Error(folder + ": has " + kFolders[1 - wanted] +
                  " only; choose it with --dataset "
                  "'{type: sceneflow, pass: " +
                  kNames[1 - wanted] + "}'");
    }
    add_sequences(images, {}, found, [&](const Listing& sequence, const fs::path& below) {
      add_frames(sequence, below, top.folder("disparity"), found);
    });
    return found;
  }

 private:
  // The cameras are published in units of the renderer, not in mm; so there is no calibration.
  static void add_frames(const Listing& sequence, const fs::path& below,
                         const std::string& disparity, std::vector<SceneFiles>& found) {
    const Listing left(sequence.folder("left")), right(sequence.folder("right"));
    for (const std::string& file : left.files()) {
      if (!dataset::is_image(file)) continue;
      const std::string frame = file.substr(0, file.rfind('.'));
      SceneFiles& scene = found.emplace_back();
      scene.name = scene_name(below, frame);
      scene.images = {left.file(file), find_path(right.path() + "/" + file), "", ""};
      const fs::path truth = fs::path(disparity) / below;
      if (!disparity.empty()) {  // positive numbers in both views
        scene.truth.disparity = {file_if_there(truth / "left" / (frame + ".pfm")), 1};
        scene.truth.reverse = {file_if_there(truth / "right" / (frame + ".pfm")), -1};
      }
      if (scene.truth.disparity.file.empty()) {
        scene.missing.push_back("disparity/.../left/" + frame +
                                ".pfm: true disparities to judge by");
      } else if (scene.truth.reverse.file.empty()) {
        scene.missing.push_back("disparity/.../right/" + frame +
                                ".pfm, to derive from it which pixels are not occluded");
      }
    }
  }

  Parameters p_;
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<SceneFlow>(
      "sceneflow", "SceneFlow sets of Freiburg: FlyingThings3D, Driving and Monkaa, unpacked.",
      "Mayer et al., A large dataset to train convolutional networks for disparity, optical flow, "
      "and scene flow estimation, CVPR 2016");
}
