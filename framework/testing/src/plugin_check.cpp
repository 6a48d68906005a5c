// SPDX-License-Identifier: Apache-2.0
// What children tell, a line of JSON each: {"failure": TEXT}, {"stage": [KIND, NAME]},
// {"begin": CHECK}, {"end": [FAULT, ...]}.
#include "xgm/testing/plugin_check.hpp"

#include <algorithm>

#include "run_apart.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/json.hpp"
#include "xgm/base/suggest.hpp"

namespace xgm::testing {
namespace {

/// In the child: loads the file, or tells why that fails.
bool load(Registry& registry, const std::string& file, const Tell& tell) {
  const std::size_t before = registry.failures().size();
  if (registry.load(file)) return true;
  tell(Json{{"failure", registry.failures().at(before).reason}}.dump());
  return false;
}

/// In the child.
void tell_stages(Registry registry, const std::string& file, const Tell& tell) {
  if (!load(registry, file, tell)) return;
  for (const PluginInfo* plugin : registry.plugins()) {
    if (plugin->origin == file) tell(Json{{"stage", {plugin->kind, plugin->name}}}.dump());
  }
}

std::string yaml_of(const StageVerdict& stage, const std::vector<Override>& parameters) {
  std::string yaml = "{type: " + stage.name;
  for (const Override& parameter : parameters) {
    if (!parameter.path.starts_with(stage.name + ".")) continue;
    yaml += ", " + parameter.path.substr(stage.name.size() + 1) + ": " + parameter.value;
  }
  return yaml + "}";
}

/// In the child.
void tell_checks(Registry registry, const PluginCheck& check, const StageVerdict& stage,
                 bool only_names, const Tell& tell) {
  if (!load(registry, check.file, tell)) return;
  std::shared_ptr<const Stage> made;
  try {
    made = make_stage(stage.kind, yaml_of(stage, check.parameters), registry);
  } catch (const Error& error) {
    tell(Json{{"failure", "cannot be made: " + std::string(error.what())}}.dump());
    return;
  }
  bool begun = false;
  const Watch watch{.begin =
                        [&](const std::string& name) {
                          begun = true;
                          tell(Json{{"begin", name}}.dump());
                        },
                    .end =
                        [&](const Violations& faults) {
                          tell(Json{{"end", Json(faults)}}.dump());
                        },
                    .only_names = only_names};
  const Violations violations = check_stage(*made, watch);
  if (!begun && !violations.empty()) tell(Json{{"failure", violations.front()}}.dump());
}

/// Here: takes a line of tell_checks().
void take(const Json& told, StageVerdict& stage) {
  if (const Json* failure = told.find("failure")) stage.failure = failure->text();
  if (const Json* name = told.find("begin")) stage.checks.push_back({name->text()});
  if (const Json* faults = told.find("end")) {
    for (const Json& fault : *faults) stage.checks.back().faults.push_back(fault.text());
  }
}

/// The checks that a stage which died in one of them did not come to. They are told by a child that
/// makes none.
void add_skipped(const PluginCheck& check, const Registry& registry, StageVerdict& stage) {
  StageVerdict all;
  run_apart([&](const Tell& tell) { tell_checks(registry, check, stage, true, tell); },
            [&](const std::string& line) { take(Json::parse(line), all); }, check.seconds);
  for (std::size_t i = stage.checks.size(); i < all.checks.size(); ++i) {
    stage.checks.push_back({.name = all.checks[i].name, .is_skipped = true});
  }
}

void check_stage_apart(const PluginCheck& check, const Registry& registry, StageVerdict& stage) {
  bool in_check = false;
  const std::string death =
      run_apart([&](const Tell& tell) { tell_checks(registry, check, stage, false, tell); },
                [&](const std::string& line) {
                  const Json told = Json::parse(line);
                  in_check = told.contains("begin");
                  take(told, stage);
                },
                check.seconds);
  if (death.empty()) return;
  if (!in_check) {
    stage.failure = "dies outside of any check: " + death;
    return;
  }
  stage.checks.back().faults.push_back("the stage dies: " + death);
  stage.failure = "the checks after '" + stage.checks.back().name + "' were not made";
  add_skipped(check, registry, stage);
}

void require_stages_of(const std::vector<Override>& parameters, const PluginVerdict& verdict) {
  std::vector<std::string> names;
  for (const StageVerdict& stage : verdict.stages) names.push_back(stage.name);
  for (const Override& parameter : parameters) {
    const std::string name = parameter.path.substr(0, parameter.path.find('.'));
    const bool has_parameter = parameter.path.size() > name.size() + 1;
    if (has_parameter && std::ranges::find(names, name) != names.end()) continue;
    throw UsageError("--set " + parameter.path +
                     ": write STAGE.PARAMETER=VALUE with a stage of the file; " +
                     suggest(name, names, "stages"));
  }
}

}  // namespace

bool StageVerdict::passed() const {
  return failure.empty() && std::ranges::all_of(checks, &CheckVerdict::passed);
}

bool PluginVerdict::passed() const {
  return failure.empty() && std::ranges::all_of(stages, &StageVerdict::passed);
}

PluginVerdict check_plugin(const PluginCheck& check, const Registry& registry) {
  PluginVerdict verdict;
  const std::string death =
      run_apart([&](const Tell& tell) { tell_stages(registry, check.file, tell); },
                [&](const std::string& line) {
                  const Json told = Json::parse(line);
                  if (const Json* failure = told.find("failure")) verdict.failure = failure->text();
                  if (const Json* stage = told.find("stage")) {
                    const auto& words = stage->elements();
                    verdict.stages.push_back({words.at(0).text(), words.at(1).text()});
                  }
                },
                check.seconds);
  if (!death.empty()) verdict.failure = "dies while it is loaded: " + death;
  if (!verdict.failure.empty()) return verdict;
  if (verdict.stages.empty()) verdict.failure = "has no stages";
  require_stages_of(check.parameters, verdict);
  for (StageVerdict& stage : verdict.stages) check_stage_apart(check, registry, stage);
  return verdict;
}

}  // namespace xgm::testing
