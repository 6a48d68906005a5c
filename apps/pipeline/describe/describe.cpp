// SPDX-License-Identifier: Apache-2.0
// pipeline describe: which parameters does a plugin have?
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/pipelines.hpp"
#include "xgm/pipeline/describe.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::cli {
namespace {

struct Options {
  std::string plugin;
  bool json = false;
  PluginOptions plugins;
};

int describe(const Options& options) {
  const Registry registry = make_registry(options.plugins);
  const std::vector<const PluginInfo*> plugins = find_plugins(options.plugin, registry);
  const bool list = options.json && plugins.size() > 1;
  if (list) std::cout << "[\n";
  for (std::size_t i = 0; i < plugins.size(); ++i) {
    if (i > 0) std::cout << (list ? ",\n" : "\n");
    std::string text = options.json ? describe_json(*plugins[i]) : describe_text(*plugins[i]);
    while (text.ends_with('\n')) text.pop_back();
    std::cout << text << '\n';
  }
  if (list) std::cout << "]\n";
  return kOk;
}

}  // namespace

void add_describe(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command = line.add("describe", "Describe a plugin and its parameters",
                             [options] { return describe(*options); });
  command
      .option("plugin", options->plugin,
              "Name, or KIND/NAME; if several kinds have the name, all are shown")
      .type_name("PLUGIN")
      .required();
  command.flag("--json", options->json, "For programs: an object, or a list if several match");
  add_plugin_options(command, options->plugins);
}

}  // namespace xgm::cli
