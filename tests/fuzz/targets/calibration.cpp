// SPDX-License-Identifier: Apache-2.0
// Calibrations that come with data sets. The first byte tells which: 'm' for Middlebury's
// calib.txt, 'k' for KITTI's; the rest is the file.
#include <cmath>
#include <filesystem>

#include "fuzz/support/target.hpp"
#include "support/temporary_folder.hpp"
#include "xgm/io/scene.hpp"

namespace xgm::fuzz {
namespace {

/// A folder with one scene, whose images nobody opens.
struct Layout {
  std::string dataset;
  std::string calibration;
  testing::TemporaryFolder folder{};

  Layout(std::string name, std::string file, const std::vector<std::string>& images)
      : dataset(std::move(name)), calibration(std::move(file)) {
    for (const std::string& image : images) write(image, "");
    write(calibration, "");
  }
  std::string write(const std::string& name, std::string_view bytes) const {
    std::filesystem::create_directories(std::filesystem::path(folder / name).parent_path());
    return folder.write(name, std::string(bytes));
  }
};

void check_scene(const SceneFiles& scene, const std::string& file) {
  for (const FileFault& fault : scene.faults) {
    if (fault.file != file) continue;  // the images are empty
    require(fault.message.starts_with(file), "a fault begins with its place");
    require(!scene.calibration, "a faulty file calibrates nothing");
  }
  require(!scene.disparities || !scene.disparities->empty(), "there is a disparity to search");
  require(scene.calibrated_size.width >= 0 && scene.calibrated_size.height >= 0,
          "no side of an image is negative");
  if (!scene.calibration) return;
  const Calibration& c = *scene.calibration;
  require(std::isfinite(c.focal) && c.focal > 0, "a focal length is above 0");
  require(std::isfinite(c.baseline) && c.baseline > 0, "a baseline is above 0");
  require(std::isfinite(c.cx) && std::isfinite(c.cy) && std::isfinite(c.doffs),
          "what is calibrated is a number");
}

}  // namespace

void check(std::string_view input) {
  static const Layout middlebury("middlebury_v3", "calib.txt", {"im0.png", "im1.png"});
  static const Layout kitti("kitti", "calib_cam_to_cam/000000.txt",
                            {"image_2/000000_10.png", "image_3/000000_10.png"});
  if (input.empty()) return;
  const Layout& layout = input.front() == 'k' ? kitti : middlebury;
  const std::string file = layout.write(layout.calibration, input.substr(1));
  const auto scenes = find_scenes(layout.folder.path(), builtins(), layout.dataset);
  require(scenes.size() == 1, "a faulty calibration is no reason not to find its scene");
  check_scene(scenes.front(), file);
}

std::vector<std::string> seeds() {
  return {
      "mcam0=[1000.5 0 320; 0 1000.5 240; 0 0 1]\ncam1=[1000.5 0 330; 0 1000.5 240; 0 0 1]\n"
      "doffs=10\nbaseline=193.001\nwidth=640\nheight=480\nndisp=64\nisint=0\nvmin=2\nvmax=60\n",
      "mndisp=64\n",
      "kP_rect_02: 700 0 600 45 0 700 170 0 0 0 1 0\n"
      "P_rect_03: 700 0 600 -340 0 700 170 0 0 0 1 0\n",
      "kP2: 7e2 0 6e2 4.5e1 0 7e2 1.7e2 0 0 0 1 0\nP3: 7e2 0 6e2 -3.4e2 0 7e2 1.7e2 0 0 0 1 0\n"};
}

std::vector<std::string> words() {
  return {"cam0=[",  "cam1=[", "doffs=",      "baseline=", "ndisp=", "width=",
          "height=", "vmin=",  "P_rect_02: ", "P2: ",      "; ",     "]",
          "\r\n",    "nan",    "inf",         "1e308",     "1e-320", "-0"};
}

}  // namespace xgm::fuzz
