// SPDX-License-Identifier: Apache-2.0
#include "plugins/dataset/file_layouts/middlebury_layout.hpp"

#include <algorithm>
#include <string_view>

#include "plugins/dataset/file_layouts/folders.hpp"

namespace xgm::dataset {
namespace {

/// Whether at least one image is there: half a pair is a scene that lacks the other half.
bool has_images(const Listing& folder) {
  if (is_middlebury_2001(folder)) return false;
  return !folder.image("im0").empty() || !folder.image("im1").empty();
}

std::string first_file(const Listing& folder, const char* name, const char* other) {
  const std::string file = folder.file(name);
  return file.empty() ? folder.file(other) : file;
}

}  // namespace

SceneFolders pair_folders(const std::string& folder) { return scene_folders(folder, has_images); }

void add_images(SceneFiles& scene, const Listing& folder) {
  scene.images.left = image_or(folder, "im0", ".png");
  scene.images.right = image_or(folder, "im1", ".png");
}

bool is_tsukuba(const Listing& folder) {
  return !folder.image("scene1.row3.col3").empty() || !folder.image("scene1.row3.col4").empty();
}

bool is_map(const Listing& folder) {
  const auto has = [&](const char* stem) { return !folder.image(stem).empty(); };
  return !has("im2") && has("im0") && has("im1") && !folder.file("disp0.pgm").empty();
}

// Half a pair is a scene that lacks the other half, if its truth tells what it is.
bool is_middlebury_2001(const Listing& folder) {
  const auto has = [&](const char* stem) { return !folder.image(stem).empty(); };
  const bool is_of_set = has("disp2") || has("disp6");
  return (has("im2") && has("im6")) || (is_of_set && (has("im2") || has("im6"))) ||
         is_map(folder) || is_tsukuba(folder);
}

// A word, a number and a letter for the range of its disparities: "delivery_area_1l".
bool is_eth3d_name(const std::string& name) {
  if (!name.ends_with('l') && !name.ends_with('s')) return false;
  const std::string_view stem = std::string_view(name).substr(0, name.size() - 1);
  const std::size_t line = stem.find_last_not_of("0123456789");
  if (line == std::string_view::npos || stem[line] != '_') return false;
  const std::string_view word = stem.substr(0, line);
  return line + 1 < stem.size() && !word.empty() &&
         word.find_first_not_of("_abcdefghijklmnopqrstuvwxyz") == std::string_view::npos;
}

bool are_eth3d(const std::vector<Listing>& scenes) {
  return !scenes.empty() && std::all_of(scenes.begin(), scenes.end(), [](const Listing& scene) {
    return is_eth3d_name(name_of(scene.path()));
  });
}

void add_truth(SceneFiles& scene, const Listing& folder) {
  TruthFiles& truth = scene.truth;
  truth.disparity.file = first_file(folder, "disp0GT.pfm", "disp0.pfm");
  truth.reverse = {first_file(folder, "disp1GT.pfm", "disp1.pfm"), -1};
  truth.non_occluded = folder.file("mask0nocc.png");
  if (truth.disparity.file.empty()) {
    scene.missing.push_back("disp0GT.pfm (2014 set: disp0.pfm): true disparities to judge by");
  } else if (truth.non_occluded.empty() && truth.reverse.file.empty()) {
    scene.missing.push_back(
        "mask0nocc.png, or disp1GT.pfm (2014 set: disp1.pfm) to derive it from: which pixels are "
        "not occluded");
  }
}

}  // namespace xgm::dataset
