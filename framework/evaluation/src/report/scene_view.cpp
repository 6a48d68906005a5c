// SPDX-License-Identifier: Apache-2.0
#include "report/scene_view.hpp"

#include "xgm/base/error.hpp"

namespace xgm::report {
namespace {

void require_size(cv::Size size, const ReportScene& scene, const std::string& what) {
  const cv::Size wanted = scene.left.size();
  if (size == wanted) return;
  throw Error("report of " + scene.name + ": " + what + " is " + std::to_string(size.width) +
              " x " + std::to_string(size.height) + " pixels but the left image is " +
              std::to_string(wanted.width) + " x " + std::to_string(wanted.height));
}

Json parsed(const std::string& text, const Json& otherwise, const std::string& what) {
  if (text.empty()) return otherwise;
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Error&) {
    throw Error("report: " + what + " is no JSON");
  }
  if (json.is_array() || !otherwise.is_array()) return json;
  throw Error("report: " + what + " is JSON, but not a list");
}

void check(const ReportScene& scene) {
  if (scene.left.size().empty()) throw Error("report of " + scene.name + ": has no left image");
  const GroundTruth& truth = scene.truth;
  if (!truth.disparity.empty()) require_size(truth.disparity.size(), scene, "the truth");
  if (!truth.non_occluded.empty()) require_size(truth.non_occluded.size(), scene, "its mask");
  for (const ReportRun& run : scene.runs) {
    require_size(run.map.size(), scene, "the map of " + run.name);
    require_size(run.map.status.size(), scene, "the status map of " + run.name);
    if (run.map.confidence.empty()) continue;
    require_size(run.map.confidence.size(), scene, "the confidence of " + run.name);
  }
}

}  // namespace

SceneView view_of(const ReportScene& scene) {
  check(scene);
  SceneView view{scene, {}, {}, {}};
  std::vector<cv::Mat1f> maps;
  for (const ReportRun& run : scene.runs) {
    view.records.push_back(parsed(run.record_json, Json(), "the record of " + run.name));
    view.explanations.push_back(
        parsed(run.explanations_json, Json::array(), "the explanation of " + run.name));
    maps.push_back(run.map.disparity);
  }
  // The truth, if there is one, has no outliers that could spoil the colours.
  const std::vector<cv::Mat1f> truth{scene.truth.disparity};
  view.span = colour_span(view.has_truth() ? truth : maps);
  return view;
}

}  // namespace xgm::report
