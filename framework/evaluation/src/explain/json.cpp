// SPDX-License-Identifier: Apache-2.0
// An explanation for programs, the report among them.
#include <charconv>
#include <cmath>

#include "xgm/base/json.hpp"
#include "xgm/evaluation/explain.hpp"

namespace xgm {
namespace {

/// The shortest number that reads as this float again; null for NaN.
Json number(float value) {
  if (!std::isfinite(value)) return nullptr;
  std::array<char, 32> text{};
  std::to_chars(text.data(), text.data() + text.size() - 1, value);
  return std::strtod(text.data(), nullptr);
}

Json numbers(const std::vector<float>& values) {
  if (values.empty()) return nullptr;
  Json list = Json::array();
  for (const float value : values) list.push_back(number(value));
  return list;
}

Json range(Interval interval) {
  if (interval.empty()) return nullptr;
  return {interval.begin, interval.end - 1};
}

Json state(const std::optional<PixelState>& state) {
  if (!state) return nullptr;
  return {{"disparity", number(state->disparity)}, {"status", to_string(state->status)}};
}

Json candidate(const std::optional<Candidate>& candidate) {
  if (!candidate) return nullptr;
  return {{"disparity", candidate->disparity},
          {"cost", number(candidate->cost)},
          {"sum", number(candidate->sum)}};
}

Json truth(const std::optional<ExplainedTruth>& truth) {
  if (!truth) return nullptr;
  return {{"disparity", number(truth->disparity)},
          {"searched", truth->searched},
          {"cost", number(truth->nearest.cost)},
          {"sum", number(truth->nearest.sum)}};
}

void add_match(Json& json, const MatchExplanation& match) {
  json["stage"] = match.stage_path;
  json["plugin"] = match.plugin;
  json["x"] = match.pixel.x;
  json["y"] = match.pixel.y;
  json["range"] = range(match.range);
  json["costs"] = numbers(match.costs);
  json["sums"] = numbers(match.sums);
  json["winner"] = candidate(match.winner);
  json["runner_up"] = candidate(match.runner_up);
  json["shift"] = match.shift ? number(*match.shift) : Json();
  json["disparity"] = number(match.result.disparity);
  json["status"] = to_string(match.result.status);
  json["truth"] = truth(match.truth);
}

Json level(const LevelExplanation& level) {
  Json json = {{"scale", level.level.scale}, {"size", {level.size.width, level.size.height}}};
  add_match(json, level.forward);
  json["reverse"] = nullptr;
  if (level.reverse) {
    Json reverse;
    add_match(reverse, *level.reverse);
    json["reverse"] = std::move(reverse);
  }
  return json;
}

Json event(const ExplainedEvent& event) {
  return {{"stage", event.place.path},         {"plugin", event.place.plugin},
          {"scale", event.level.scale},        {"view", event.reverse ? "reverse" : "forward"},
          {"effect", to_string(event.effect)}, {"before", state(event.before)},
          {"after", state(event.after)},       {"text", event.text}};
}

Json units() {
  return {{"x, y", "px of the level"},
          {"disparity, range, shift", "px of the level"},
          {"cost, sum", "units of the cost function"}};
}

Json object(const Explanation& explanation) {
  Json json = {{"x", explanation.pixel.x},
               {"y", explanation.pixel.y},
               {"disparity", number(explanation.result.disparity)},
               {"status", to_string(explanation.result.status)},
               {"verdict", explanation.verdict},
               {"truth", explanation.truth ? number(*explanation.truth) : Json()},
               {"diagnosis", explanation.diagnosis},
               {"units", units()},
               {"levels", Json::array()},
               {"events", Json::array()}};
  for (const LevelExplanation& l : explanation.levels) json["levels"].push_back(level(l));
  for (const ExplainedEvent& e : explanation.events) json["events"].push_back(event(e));
  return json;
}

std::string text_of(const Json& json, int indent) { return json.dump(indent) + "\n"; }

}  // namespace

std::string to_json(const Explanation& explanation) { return text_of(object(explanation), 1); }

std::string to_json(const std::vector<Explanation>& explanations) {
  Json list = Json::array();
  for (const Explanation& explanation : explanations) list.push_back(object(explanation));
  return text_of(list, -1);
}

}  // namespace xgm
