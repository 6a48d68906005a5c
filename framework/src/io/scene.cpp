// SPDX-License-Identifier: Apache-2.0
#include "xgm/io/scene.hpp"

#include <array>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "io/raster.hpp"
#include "xgm/base/error.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

constexpr std::array kExtensions = {".png",  ".ppm", ".pgm",  ".pfm", ".tif",
                                    ".tiff", ".jpg", ".jpeg", ".bmp"};
constexpr std::uint64_t kLongestCalibration = 1 << 16;
constexpr int kLargestDisparity = 1 << 20;

std::string find_image(const fs::path& folder, const std::string& stem) {
  for (const char* extension : kExtensions) {
    const fs::path file = folder / (stem + extension);
    if (fs::is_regular_file(file)) return file.string();
  }
  throw Error(folder.string() + ": has no " + stem +
              ".png (or .ppm, .tif, .jpg, ...); give a Middlebury or ETH3D folder, or the images "
              "with --left and --right");
}

std::string trimmed(const std::string& text) {
  constexpr const char* kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// The value of ndisp in lines "key=value"; other keys are of no use here.
std::optional<Interval> read_ndisp(const std::string& file) {
  std::istringstream lines(read_file(file, kLongestCalibration));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || trimmed(line.substr(0, equals)) != "ndisp") continue;
    const std::string value = trimmed(line.substr(equals + 1));
    int count = 0;
    const auto [end, failure] = std::from_chars(value.data(), value.data() + value.size(), count);
    if (failure != std::errc() || end != value.data() + value.size() || count < 1 ||
        count > kLargestDisparity) {
      throw Error(file + ":" + std::to_string(number) + ": ndisp is \"" + value +
                  "\"; it must be a number of disparities, 1 or more");
    }
    return Interval{0, count};
  }
  return std::nullopt;
}

TruthFiles find_truth(const fs::path& folder) {
  TruthFiles truth;
  const fs::path disparity = folder / "disp0GT.pfm", mask = folder / "mask0nocc.png";
  if (fs::is_regular_file(disparity)) truth.disparity.file = disparity.string();
  if (fs::is_regular_file(mask)) truth.non_occluded = mask.string();
  return truth;
}

void note_masked_share(const Image& image, const char* which, std::vector<std::string>& notes) {
  if (image.valid.empty()) return;
  const double share = 1 - cv::countNonZero(image.valid) / static_cast<double>(image.valid.total());
  std::ostringstream text;
  text.precision(3);
  text << which << " image: " << 100 * share << " % of the pixels have no data";
  notes.push_back(text.str());
}

}  // namespace

SceneFiles find_scene(const std::string& folder) {
  std::error_code unusable;
  if (!fs::exists(folder, unusable)) throw Error(folder + ": no such folder; check the path");
  if (!fs::is_directory(folder, unusable)) {
    throw Error(folder + ": is a file; give the folder of the scene, or --left and --right");
  }
  SceneFiles files;
  files.name = folder;
  files.images.left = find_image(folder, "im0");
  files.images.right = find_image(folder, "im1");
  const fs::path calibration = fs::path(folder) / "calib.txt";
  if (fs::exists(calibration)) {
    files.calibration_file = calibration.string();
    files.disparities = read_ndisp(files.calibration_file);
  }
  files.truth = find_truth(folder);
  return files;
}

Scene load_scene(const SceneFiles& files) {
  Scene scene;
  scene.name = files.name;
  scene.disparities = files.disparities;
  ReadPair read = read_pair(files.images);
  scene.pair = std::move(read.pair);
  scene.notes = std::move(read.notes);
  note_masked_share(scene.pair.base, "left", scene.notes);
  note_masked_share(scene.pair.match, "right", scene.notes);
  for (const auto& [role, file] : {std::pair{"left", files.images.left},
                                   {"right", files.images.right},
                                   {"left mask", files.images.left_mask},
                                   {"right mask", files.images.right_mask},
                                   {"calibration", files.calibration_file}}) {
    if (!file.empty()) scene.inputs.push_back({role, file, identify_file(file)});
  }
  return scene;
}

Interval clip_to_width(Interval interval, int width) {
  return intersect(interval, {1 - width, width});
}

}  // namespace xgm
