// SPDX-License-Identifier: Apache-2.0
#include "xgm/evaluation/evaluation_json.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace xgm {
namespace {

constexpr std::array kFigures = {std::pair{"invalid", &Evaluation::invalid},
                                 std::pair{"average_error_px", &Evaluation::average_error},
                                 std::pair{"rms_px", &Evaluation::rms},
                                 std::pair{"a50_px", &Evaluation::a50},
                                 std::pair{"a90_px", &Evaluation::a90},
                                 std::pair{"a95_px", &Evaluation::a95},
                                 std::pair{"a99_px", &Evaluation::a99},
                                 std::pair{"d1", &Evaluation::d1}};

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json to_json(const SparsificationCurve& curve) {
  return {{"value", curve.value},
          {"optimal", curve.optimal},
          {"area", curve.area},
          {"optimal_area", curve.optimal_area}};
}

}  // namespace

Json to_json(const RegionEvaluation& region) {
  const Evaluation& evaluation = region.evaluation;
  Json json = {{"region", region.region}, {"judged_pixels", evaluation.judged}};
  for (const auto& [name, figure] : kFigures) json[name] = number(evaluation.*figure);
  json["coverage"] = evaluation.coverage();
  json["thresholds"] = Json::array();
  for (const ThresholdScore& score : evaluation.at) {
    json["thresholds"].push_back(
        {{"delta_px", score.delta}, {"bad", score.bad}, {"total", score.total}});
  }
  return json;
}

Evaluation evaluation_of(const Json& region) {
  const auto figure = [](const Json& json, const char* name) {
    const Json& value = json.at(name);
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.number();
  };
  Evaluation evaluation;
  evaluation.judged = static_cast<std::int64_t>(region.at("judged_pixels").number());
  for (const auto& [name, member] : kFigures) evaluation.*member = figure(region, name);
  for (const Json& score : region.at("thresholds")) {
    evaluation.at.push_back(
        {figure(score, "delta_px"), figure(score, "bad"), figure(score, "total")});
  }
  return evaluation;
}

Json to_json(const std::vector<RegionEvaluation>& evaluations) {
  Json json = Json::array();
  for (const RegionEvaluation& region : evaluations) json.push_back(to_json(region));
  return json;
}

Json to_json(const RegionSparsification& region) {
  const Sparsification& sparsification = region.sparsification;
  Json json = {{"region", region.region},
               {"pixels", sparsification.pixels},
               {"kept", sparsification.kept},
               {"thresholds", Json::array()},
               {"average_error_px", to_json(sparsification.average_error)}};
  for (std::size_t i = 0; i < sparsification.deltas.size(); ++i) {
    json["thresholds"].push_back(
        {{"delta_px", sparsification.deltas[i]}, {"bad", to_json(sparsification.bad[i])}});
  }
  return json;
}

}  // namespace xgm
