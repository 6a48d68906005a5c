// SPDX-License-Identifier: Apache-2.0
#include "xgm/pipeline/depth_files.hpp"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <string_view>

#include "xgm/base/error.hpp"
#include "xgm/base/file_names.hpp"
#include "xgm/io/output_folder.hpp"
#include "xgm/io/point_cloud.hpp"

namespace xgm {
namespace fs = std::filesystem;
namespace {

/// What a file holds is known by its name, and no two outputs share one.
void require_ending(const char* option, const std::string& file,
                    std::initializer_list<std::string_view> endings) {
  if (file.empty()) return;
  const std::string ending = lower_case(fs::path(file).extension().string());
  if (std::find(endings.begin(), endings.end(), ending) != endings.end()) return;
  throw UsageError(std::string(option) + " " + file + ": the name must end in " +
                   std::string(*endings.begin()));
}

void require_cameras(const std::string& option, const SceneRequest& request) {
  const bool known =
      std::visit([](const auto& scene) { return scene.calibration.has_value(); }, request.scene);
  if (known) return;
  if (const auto* scene = std::get_if<SceneFiles>(&request.scene)) {
    const std::string fault = fault_of(*scene, scene->calibration_file);
    if (!fault.empty()) throw UsageError(option + fault);
  }
  throw UsageError(option +
                   "the cameras are not known; give a scene folder whose calib.txt has cam0, "
                   "doffs and baseline ('pipeline scenes FOLDER' tells what is missing)");
}

void require_no_input(const char* option, const std::string& file, const SceneFiles& scene) {
  const TruthFiles& truth = scene.truth;
  for (const std::string& input :
       {scene.images.left, scene.images.right, scene.images.left_mask, scene.images.right_mask,
        truth.disparity.file, truth.reverse.file, truth.visible.file, truth.non_occluded,
        truth.objects}) {
    std::error_code unusable;
    if (file.empty() || input.empty() || !fs::equivalent(file, input, unusable)) continue;
    throw UsageError(std::string(option) + " " + file +
                     ": is a file of the scene, which would be lost; give another name");
  }
}

void require_writable_file(const char* option, const std::string& file) {
  if (file.empty()) return;
  const fs::path folder = fs::path(file).parent_path();
  std::error_code unusable;
  const std::string mistake = std::string(option) + " " + file + ": ";
  if (fs::is_directory(file, unusable)) throw UsageError(mistake + "is a folder; give a file");
  if (!folder.empty() && !fs::is_directory(folder, unusable)) {
    throw UsageError(mistake + "there is no folder " + folder.string() + "; make it first");
  }
  require_writable(folder.string(), std::string(option) + " ");
}

}  // namespace

DepthFiles check_depth_files(DepthFiles files, const SceneRequest& request) {
  if (files.empty()) return files;
  require_cameras(files.cloud.empty() ? "--depth: " : "--cloud: ", request);
  if (files.depth.empty()) {
    files.depth = fs::path(files.cloud).replace_extension().string() + "_depth.tiff";
  }
  require_ending("--cloud", files.cloud, {".ply"});
  require_ending("--depth", files.depth, {".tiff", ".tif"});
  if (const auto* scene = std::get_if<SceneFiles>(&request.scene)) {
    require_no_input("--depth", files.depth, *scene);
  }
  require_writable_file("--cloud", files.cloud);
  require_writable_file("--depth", files.depth);
  return files;
}

void require_cameras_of_size(const DepthFiles& files, const SceneRequest& request, cv::Size size) {
  const auto* scene = std::get_if<SceneFiles>(&request.scene);
  if (!files.empty() && scene != nullptr) require_calibrated_size(*scene, size);
}

std::size_t write_depth_files(const DepthFiles& files, const DisparityMap& map,
                              const Calibration& cameras, const Image& left) {
  if (!files.depth.empty()) write_depths(files.depth, depths(map.disparity, cameras));
  if (files.cloud.empty()) return 0;
  return write_point_cloud(files.cloud, map.disparity, cameras, left);
}

}  // namespace xgm
