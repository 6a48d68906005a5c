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

/// Whether the folder is there once `made` is.
bool comes_with(const fs::path& folder, const std::string& made) {
  std::error_code unusable;
  const fs::path rest = fs::weakly_canonical(fs::absolute(made, unusable), unusable)
                            .lexically_relative(fs::weakly_canonical(folder, unusable));
  return !made.empty() && !rest.empty() && *rest.begin() != "..";
}

void require_writable_file(const char* option, const std::string& file, const std::string& made) {
  if (file.empty()) return;
  const fs::path folder = fs::absolute(file).parent_path();
  std::error_code unusable;
  if (fs::is_directory(folder, unusable)) {
    require_writable(folder.string(), std::string(option) + " ");
  } else if (!comes_with(folder, made)) {
    throw UsageError(std::string(option) + " " + file + ": there is no folder " +
                     fs::path(file).parent_path().string() + "; make it first");
  }
}

}  // namespace

DepthFiles check_depth_files(DepthFiles files, const SceneRequest& request,
                             const std::string& made) {
  if (files.empty()) return files;
  require_cameras(files.cloud.empty() ? "--depth: " : "--cloud: ", request);
  if (files.depth.empty()) {
    files.depth = fs::path(files.cloud).replace_extension().string() + "_depth.tiff";
  }
  require_ending("--cloud", files.cloud, {".ply"});
  require_ending("--depth", files.depth, {".tiff", ".tif"});
  require_writable_file("--cloud", files.cloud, made);
  require_writable_file("--depth", files.depth, made);
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
