// SPDX-License-Identifier: Apache-2.0
#include "run_depth.hpp"

#include <filesystem>

#include "output_folder.hpp"
#include "xgm/io/point_cloud.hpp"

namespace xgm::cli {
namespace fs = std::filesystem;
namespace {

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
    depth.depth = (fs::path(depth.cloud).parent_path() / "depth.tiff").string();
  }
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
