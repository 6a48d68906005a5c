// SPDX-License-Identifier: Apache-2.0
// pipeline new-plugin: begins a plugin.
#include "xgm/testing/new_plugin.hpp"

#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/pipelines.hpp"

namespace xgm::cli {
namespace {

struct Options {
  std::string kind, name, output;
  bool python = false;
  PluginOptions plugins;
};

int new_plugin(const Options& options) {
  const testing::NewPlugin plugin{
      .kind = options.kind,
      .name = options.name,
      .folder = options.output.empty() ? options.name : options.output,
      .language = options.python ? testing::Language::python : testing::Language::cpp};
  testing::write_new_plugin(plugin, make_registry(options.plugins));
  std::cout << "written: " << plugin.folder << "; "
            << (std::filesystem::path(plugin.folder) / "README.md").string()
            << " says how to go on\n";
  return kOk;
}

}  // namespace

void add_new_plugin(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command =
      line.add("new-plugin", "Begin a plugin: a folder that builds, with a test and a pipeline",
               [options] { return new_plugin(*options); });
  command
      .option("kind", options->kind, "Kind of stage: cost, filter, matcher, ... (docs/reference)")
      .type_name("KIND")
      .required();
  command.option("name", options->name, "Name of the plugin: small letters, digits and _")
      .type_name("NAME")
      .required();
  command.flag("--python", options->python,
               "A stage in Python, for programs that use the package xgm, instead of C++");
  command.option("-o,--output", options->output, "Folder to make; without it NAME")
      .type_name("DIR");
  add_plugin_options(command, options->plugins);
}

}  // namespace xgm::cli
