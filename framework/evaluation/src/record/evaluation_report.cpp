// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/evaluation_report.hpp"

#include <algorithm>

#include "xgm/base/json.hpp"
#include "xgm/evaluation/evaluation_json.hpp"
#include "xgm/evaluation/record_json.hpp"
#include "xgm/plugin/version.hpp"

namespace xgm {
namespace {

constexpr int kFormat = 1;  // raised when a reader would have to change

Json to_json(const EvaluationRules& rules) {
  Json json = {{"thresholds_px", rules.deltas}, {"scale", rules.scale}, {"clip", nullptr}};
  if (!rules.clip.empty()) {
    json["clip"] = {{"first", rules.clip.begin}, {"last", rules.clip.end - 1}};
  }
  return json;
}

/// Cells of a line, with the digits of JSON.
using Cells = std::vector<std::pair<std::string, Json>>;

/// Areas of a region's curves; empty where no pixel of it has a disparity.
Cells areas_of(const std::string& region, const EvaluationReport& report) {
  const auto& all = report.confidence;
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const auto& candidate) { return candidate.region == region; });
  Cells cells;
  const auto add = [&](const std::string& name, const auto& curve_of) {
    const bool known = found != all.end();
    cells.emplace_back(name + "_area", known ? Json(curve_of().area) : Json());
    cells.emplace_back(name + "_optimal_area", known ? Json(curve_of().optimal_area) : Json());
  };
  for (std::size_t i = 0; i < report.rules.deltas.size(); ++i) {
    add(
        "bad_" + Json(report.rules.deltas[i]).dump(), [&]() -> const auto& {
          return found->sparsification.bad[i];
        });
  }
  add(
      "average_error_px", [&]() -> const auto& { return found->sparsification.average_error; });
  return cells;
}

/// The fields of JSON in their order; thresholds become columns "bad_1.0", "total_1.0".
Cells cells_of(const RegionEvaluation& region) {
  Cells cells;
  const Json json = to_json(region);
  for (const auto& [name, value] : json.members()) {
    if (name != "thresholds") cells.emplace_back(name, value);
  }
  for (const ThresholdScore& score : region.evaluation.at) {
    const std::string delta = Json(score.delta).dump();
    cells.emplace_back("bad_" + delta, score.bad);
    cells.emplace_back("total_" + delta, score.total);
  }
  return cells;
}

std::string text_of(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.text() : value.dump();
}

}  // namespace

std::string to_json(const EvaluationReport& report) {
  Json json;
  json["format"] = kFormat;
  json["versions"] = {{"xgm", XGM_VERSION}};
  json["inputs"] = to_json(report.inputs);
  json["width"] = report.size.width;
  json["height"] = report.size.height;
  json["rules"] = to_json(report.rules);
  json["truth"] = to_json(report.regions);
  if (!report.confidence.empty()) json["confidence"] = Json::array();
  for (const auto& region : report.confidence) json["confidence"].push_back(to_json(region));
  return json.dump(2) + "\n";
}

std::string to_csv(const EvaluationReport& report) {
  std::string headings, lines;
  for (const RegionEvaluation& region : report.regions) {
    Cells cells = cells_of(region);
    if (!report.confidence.empty()) {
      for (auto& cell : areas_of(region.region, report)) cells.push_back(std::move(cell));
    }
    headings.clear();
    for (const auto& [name, value] : cells) {
      headings += name + ',';
      lines += text_of(value) + ',';
    }
    headings.back() = lines.back() = '\n';
  }
  return headings + lines;
}

}  // namespace xgm
