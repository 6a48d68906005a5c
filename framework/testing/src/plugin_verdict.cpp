// SPDX-License-Identifier: Apache-2.0
// What a check of a plugin file has found, for programs.
#include "xgm/base/json.hpp"
#include "xgm/testing/plugin_check.hpp"

namespace xgm::testing {
namespace {

Json message_of(const std::string& failure) { return failure.empty() ? Json() : Json(failure); }

Json to_json(const CheckVerdict& check) {
  const char* const result = check.is_skipped ? "skipped" : check.passed() ? "passed" : "failed";
  return {{"name", check.name}, {"result", result}, {"messages", Json(check.faults)}};
}

Json to_json(const StageVerdict& stage) {
  Json checks = Json::array();
  for (const CheckVerdict& check : stage.checks) checks.push_back(to_json(check));
  return {{"kind", stage.kind},
          {"name", stage.name},
          {"passed", stage.passed()},
          {"message", message_of(stage.failure)},
          {"checks", std::move(checks)}};
}

}  // namespace

std::string to_json(const std::string& file, const PluginVerdict& verdict) {
  Json stages = Json::array();
  for (const StageVerdict& stage : verdict.stages) stages.push_back(to_json(stage));
  return Json{{"file", file},
              {"passed", verdict.passed()},
              {"message", message_of(verdict.failure)},
              {"stages", std::move(stages)}}
      .dump(2);
}

}  // namespace xgm::testing
