// SPDX-License-Identifier: Apache-2.0
#include "run_depth.hpp"

#include <algorithm>
#include <filesystem>

#include "output_folder.hpp"
#include "xgm/io/point_cloud.hpp"

namespace xgm::cli {
namespace fs = std::filesystem;
namespace {

/// What a file holds is known by its name, and no two outputs share one.
void require_ending(const char* option, const std::string& file,
                    std::initializer_list<std::string_view> endings) {
  if (file.empty()) return;
  const std::string ending = fs::path(file).extension().string();
  if (std::find(endings.begin(), endings.end(), ending) != endings.end()) return;
  throw UsageError(std::string(option) + " " + file + ": the name must end in " +
                   std::string(*endings.begin()));
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
  require_writable(std::string(option) + " ", folder.string());
}

}  // namespace

std::optional<DepthPlan> plan_depth(const RunOptions& options, const Plan& plan) {
  if (options.cloud.empty() && options.depth.empty()) return std::nullopt;
  if (!plan.scene || !plan.scene->calibration) {
    const std::string what = options.cloud.empty() ? "--depth" : "--cloud";
    throw UsageError(what +
                     ": the cameras are not known; give a scene folder whose calib.txt has cam0, "
                     "doffs and baseline ('pipeline scenes FOLDER' tells what is missing)");
  }
  DepthPlan depth{options.cloud, options.depth, *plan.scene->calibration};
  if (depth.depth.empty()) {
    depth.depth = fs::path(depth.cloud).replace_extension().string() + "_depth.tiff";
  }
  require_ending("--cloud", depth.cloud, {".ply"});
  require_ending("--depth", depth.depth, {".tiff", ".tif"});
  require_no_input("--depth", depth.depth, *plan.scene);
  require_writable_file("--cloud", depth.cloud);
  require_writable_file("--depth", depth.depth);
  return depth;
}

std::string write_depth_files(const DepthPlan& plan, const DisparityMap& map, const Image& left) {
  write_depths(plan.depth, depths(map.disparity, plan.cameras));
  std::string text = "depth:   " + plan.depth + " (mm)\n";
  if (plan.cloud.empty()) return text;
  const std::size_t count = write_point_cloud(plan.cloud, map.disparity, plan.cameras, left);
  return text + "cloud:   " + plan.cloud + ", " + std::to_string(count) + " points (mm)\n";
}

}  // namespace xgm::cli
