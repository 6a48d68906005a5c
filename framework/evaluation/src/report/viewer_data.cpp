// SPDX-License-Identifier: Apache-2.0
#include "report/viewer_data.hpp"

#include "report/pictures.hpp"

namespace xgm::report {
namespace {

Json ramp_json(const Ramp& ramp) {
  Json colours = Json::array();
  for (const cv::Vec3b& c : ramp) colours.push_back({c[2], c[1], c[0]});
  return colours;
}

Json classes_json(const std::vector<Class>& classes) {
  Json list = Json::array();
  for (const Class& c : classes) list.push_back({{"name", c.name}, {"colour", css(c.colour)}});
  return list;
}

/// Where the shown pixels of a map lie in the scene.
Json grid(const Sampling& sampling, double scale) {
  return {{"width", sampling.full.width},
          {"height", sampling.full.height},
          {"stride", sampling.stride},
          {"scale", scale}};
}

Json level_json(const ReportLevel& level, double pixels) {
  const Sampling sampling = Sampling::within(level.map.size(), pixels / 2);
  Json json = {{"grid", grid(sampling, level.level.scale)},
               {"disparity", packed_numbers(sampled(level.map.disparity, sampling))},
               {"status", packed_codes(sampled(level.map.status, sampling))}};
  if (level.range) {
    const RangeMaps maps = range_maps(*level.range, sampling);
    json["first"] = packed_numbers(maps.first);
    json["last"] = packed_numbers(maps.last);
  }
  return json;
}

Json run_json(const SceneView& view, std::size_t i, const Sampling& sampling, double pixels) {
  const ReportRun& run = view.scene.runs[i];
  Json json = {{"name", run.name},
               {"disparity", packed_numbers(sampled(run.map.disparity, sampling))},
               {"status", packed_codes(sampled(run.map.status, sampling))},
               {"levels", Json::array()},
               {"explanations", view.explanations[i]}};
  if (!run.map.confidence.empty()) {
    json["confidence"] = packed_numbers(sampled(run.map.confidence, sampling));
  }
  for (const ReportLevel& level : run.levels) {
    json["levels"].push_back(level_json(level, pixels));
  }
  return json;
}

Json scene_json(const SceneView& view, double pixels) {
  const ReportScene& scene = view.scene;
  const Sampling sampling = Sampling::within(scene.left.size(), pixels);
  Json json = {{"name", scene.name},
               {"grid", grid(sampling, 1)},
               {"span", {view.span.low, view.span.high}},
               {"runs", Json::array()}};
  if (view.has_truth()) {
    json["truth"] = packed_numbers(sampled(scene.truth.disparity, sampling));
    if (!scene.truth.non_occluded.empty()) {
      json["visible"] = packed_codes(sampled(scene.truth.non_occluded, sampling));
    }
  }
  for (std::size_t i = 0; i < scene.runs.size(); ++i) {
    json["runs"].push_back(run_json(view, i, sampling, pixels));
  }
  return json;
}

}  // namespace

Json viewer_data(const std::vector<SceneView>& views, double pixels) {
  Json json = {
      {"ramps", {{"disparity", ramp_json(disparity_ramp())}, {"error", ramp_json(error_ramp())}}},
      {"missing", css(kNoNumber)},
      {"statuses", classes_json(status_classes())},
      {"verdicts", classes_json(bad_classes())},
      {"errorSpan", kErrorSpan},
      {"scenes", Json::array()}};
  for (const SceneView& view : views) json["scenes"].push_back(scene_json(view, pixels));
  return json;
}

std::string script_text(const Json& json) {
  const std::string text = json.dump();
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) c == '<' ? safe += "\\u003c" : safe += c;  // no </script>, no <!--
  return safe;
}

}  // namespace xgm::report
