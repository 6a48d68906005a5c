// SPDX-License-Identifier: Apache-2.0
// pipeline check-plugin: do the stages of a plugin file keep the contracts of their kinds?
#include <algorithm>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/pipelines.hpp"
#include "xgm/base/error.hpp"
#include "xgm/testing/plugin_check.hpp"

namespace xgm::cli {
namespace {

struct Options {
  std::string file;
  std::vector<std::string> assignments;
  double seconds = 60;
  bool json = false;
};

void print(const testing::StageVerdict& stage) {
  std::cout << stage.kind << ' ' << stage.name << '\n';
  for (const testing::CheckVerdict& check : stage.checks) {
    std::cout << (check.is_skipped ? "  skipped "
                  : check.passed() ? "  passed  "
                                   : "  FAILED  ")
              << check.name << '\n';
    for (const std::string& fault : check.faults) std::cout << "            " << fault << '\n';
  }
  if (!stage.failure.empty()) std::cout << "  FAILED  " << stage.failure << '\n';
}

void print(const std::string& file, const testing::PluginVerdict& verdict) {
  for (const testing::StageVerdict& stage : verdict.stages) print(stage);
  const auto good = std::ranges::count_if(verdict.stages, &testing::StageVerdict::passed);
  std::cout << file << ": ";
  if (verdict.failure.empty()) {
    std::cout << good << " of " << verdict.stages.size() << " stages keep their contracts\n";
  } else {
    std::cout << "FAILED: " << verdict.failure << '\n';
  }
}

int check_plugin(const Options& options) {
  if (options.seconds <= 0) throw UsageError("--time-limit: give seconds above 0");
  Registry registry = Registry::with_builtins();
  add_satellites(registry);
  const testing::PluginVerdict verdict = testing::check_plugin(
      {options.file, parse_overrides(options.assignments), options.seconds}, registry);
  if (options.json) {
    std::cout << testing::to_json(options.file, verdict) << '\n';
  } else {
    print(options.file, verdict);
  }
  return verdict.passed() ? kOk : kFailed;
}

}  // namespace

void add_check_plugin(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command =
      line.add("check-plugin", "Check that the stages of a plugin file keep their contracts",
               [options] { return check_plugin(*options); });
  command.option("file", options->file, "Plugin file").type_name("FILE").required();
  command
      .option("--set", options->assignments,
              "A parameter of a stage of the file, for example upside_down.matcher=opencv_sgbm; "
              "may be given again")
      .type_name("STAGE.PARAMETER=VALUE")
      .one_value_each();
  command.option("--time-limit", options->seconds, "Seconds that each check may take")
      .type_name("SECONDS")
      .show_default();
  command.flag("--json", options->json, "For programs: all checks, as an object");
  command.footer("Exit codes: 0 all contracts are kept; 1 some are not; 2 usage.");
}

}  // namespace xgm::cli
