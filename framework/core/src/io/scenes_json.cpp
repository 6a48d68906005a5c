// SPDX-License-Identifier: Apache-2.0
// Scenes for programs: what was found of each, before an image is opened.
#include "xgm/base/json.hpp"
#include "xgm/io/scene.hpp"

namespace xgm {
namespace {

Json path(const std::string& file) { return file.empty() ? Json(nullptr) : Json(file); }

Json disparities(const DisparityFile& from) {
  if (from.file.empty()) return nullptr;
  return {{"file", from.file}, {"divisor", from.divisor == 0 ? Json(nullptr) : Json(from.divisor)}};
}

Json cameras(const Calibration& c) {
  return {{"focal_px", c.focal},
          {"cx_px", c.cx},
          {"cy_px", c.cy},
          {"doffs_px", c.doffs},
          {"baseline_mm", c.baseline}};
}

Json faults(const std::vector<FileFault>& all) {
  Json list = Json::array();
  for (const FileFault& fault : all) {
    list.push_back({{"file", fault.file}, {"message", fault.message}});
  }
  return list;
}

/// What the calibration says of the images' size; null, or a side that is null, if it does not
/// tell.
Json size(const cv::Size& pixels) {
  if (pixels == cv::Size()) return nullptr;
  const auto side = [](int length) { return length > 0 ? Json(length) : Json(nullptr); };
  return {{"width", side(pixels.width)}, {"height", side(pixels.height)}};
}

Json scene_json(const SceneFiles& scene) {
  Json json{{"name", scene.name},
            {"dataset", scene.dataset},
            {"left", scene.images.left},
            {"right", scene.images.right},
            {"left_mask", path(scene.images.left_mask)},
            {"right_mask", path(scene.images.right_mask)},
            {"disparities", nullptr},
            {"truth", disparities(scene.truth.disparity)},
            {"reverse_truth", disparities(scene.truth.reverse)},
            {"visible_truth", disparities(scene.truth.visible)},
            {"non_occluded", path(scene.truth.non_occluded)},
            {"objects", path(scene.truth.objects)},
            {"calibration_file", path(scene.calibration_file)},
            {"calibration", nullptr},
            {"calibrated_size", size(scene.calibrated_size)},
            {"weight", scene.weight},
            {"scale", scene.scale},
            {"missing", scene.missing},
            {"faults", faults(scene.faults)}};
  if (scene.disparities) {
    json["disparities"] = {{"first", scene.disparities->begin},
                           {"last", scene.disparities->end - 1}};
  }
  if (scene.calibration) json["calibration"] = cameras(*scene.calibration);
  return json;
}

}  // namespace

std::string to_json(const std::vector<SceneFiles>& scenes) {
  Json list = Json::array();
  for (const SceneFiles& scene : scenes) list.push_back(scene_json(scene));
  return list.dump(2);
}

}  // namespace xgm
