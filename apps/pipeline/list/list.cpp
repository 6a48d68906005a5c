// SPDX-License-Identifier: Apache-2.0
// pipeline list: which plugins are there?
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/pipelines.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::cli {
namespace {

struct Options {
  std::string kind;
  PluginOptions plugins;
};

int list(const Options& options) {
  const Registry registry = make_registry(options.plugins);
  if (!options.kind.empty()) require_kind(options.kind, registry);
  const std::vector<const PluginInfo*> plugins = registry.plugins(options.kind);
  std::size_t kind_width = 0, name_width = 0;
  for (const PluginInfo* plugin : plugins) {
    kind_width = std::max(kind_width, plugin->kind.size());
    name_width = std::max(name_width, plugin->name.size());
  }
  for (const PluginInfo* plugin : plugins) {
    std::cout << std::left << std::setw(static_cast<int>(kind_width) + 2) << plugin->kind
              << std::setw(static_cast<int>(name_width) + 2) << plugin->name << plugin->summary
              << " [" << (plugin->origin.empty() ? "built in" : plugin->origin) << "]\n";
  }
  for (const LoadFailure& failure : registry.failures()) {
    std::cout << "not loaded: " << failure.file << ": " << failure.reason << '\n';
  }
  return kOk;
}

}  // namespace

void add_list(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command = line.add("list", "List plugins: kind, name, what it does, where it comes from",
                             [options] { return list(*options); });
  command.option("kind", options->kind, "Only this kind (cost, filter, matcher, ...)")
      .type_name("KIND");
  add_plugin_options(command, options->plugins);
}

}  // namespace xgm::cli
