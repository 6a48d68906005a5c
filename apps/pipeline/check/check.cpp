// SPDX-License-Identifier: Apache-2.0
// pipeline check: is the configuration sound?
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/pipelines.hpp"

namespace xgm::cli {
namespace {

struct Options {
  std::vector<std::string> pipelines;
  std::vector<std::string> assignments;
  PluginOptions plugins;
};

int check(const Options& options) {
  const Registry registry = make_registry(options.plugins);
  const std::vector<Override> overrides = parse_overrides(options.assignments);
  int exit_code = kOk;
  for (const std::string& name : options.pipelines) {
    const auto loaded = load_named(name, registry, overrides);
    if (loaded) {
      std::cout << loaded->file() << ": ok\n";
    } else {
      exit_code = kUsage;
    }
  }
  return exit_code;
}

}  // namespace

void add_check(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command = line.add("check", "Check pipeline files; opens no image",
                             [options] { return check(*options); });
  command.option("pipelines", options->pipelines, "Pipeline files or names of shipped ones")
      .type_name("PIPELINE...")
      .required();
  add_set_option(command, options->assignments);
  add_plugin_options(command, options->plugins);
}

}  // namespace xgm::cli
