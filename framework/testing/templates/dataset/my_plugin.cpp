// SPDX-License-Identifier: Apache-2.0
// Data set "my_plugin": folders with a left.png and a right.png; the truth, if any, in truth.pfm.
#include <algorithm>
#include <filesystem>
#include <xgm/plugin.hpp>

namespace {

namespace fs = std::filesystem;

class MyPlugin final : public xgm::Dataset {
 public:
  struct Parameters {};
  static void describe(Parameters&, xgm::ParameterSet&) {}
  explicit MyPlugin(Parameters) {}

  std::vector<xgm::SceneFiles> scenes(const std::string& folder) const override {
    if (!fs::is_directory(folder)) throw xgm::Error(folder + ": is no folder; check the path");
    std::vector<xgm::SceneFiles> found;
    if (is_scene(folder)) found.push_back(scene(folder));
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (is_scene(entry.path())) found.push_back(scene(entry.path()));
    }
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    return found;
  }

  std::string layout() const override { return "left.png and right.png"; }

 private:
  static bool is_scene(const fs::path& folder) {
    return fs::exists(folder / "left.png") && fs::exists(folder / "right.png");
  }
  static xgm::SceneFiles scene(const fs::path& folder) {
    xgm::SceneFiles files;
    files.name = fs::absolute(folder).lexically_normal().filename().string();
    files.images.left = (folder / "left.png").string();
    files.images.right = (folder / "right.png").string();
    const fs::path truth = folder / "truth.pfm";
    if (fs::exists(truth)) files.truth.disparity.file = truth.string();
    return files;
  }
};

}  // namespace

XGM_PLUGIN(registry) {
  registry.add<MyPlugin>("my_plugin", "Folders with a left.png and a right.png.");
}
