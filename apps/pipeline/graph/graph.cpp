// SPDX-License-Identifier: Apache-2.0
// pipeline graph: the stages of a pipeline with all their parameters, defaults included.
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/pipelines.hpp"

namespace xgm::cli {
namespace {

struct Options {
  std::string pipeline;
  std::vector<std::string> assignments;
  PluginOptions plugins;
};

int graph(const Options& options) {
  const Registry registry = make_registry(options.plugins);
  const auto loaded = load_named(options.pipeline, registry, parse_overrides(options.assignments));
  if (!loaded) return kUsage;
  std::string text = loaded->graph();
  while (text.ends_with('\n')) text.pop_back();
  std::cout << text << '\n';
  return kOk;
}

}  // namespace

void add_graph(CommandLine& line) {
  auto options = std::make_shared<Options>();
  Command command = line.add("graph", "Show a pipeline as a tree of stages",
                             [options] { return graph(*options); });
  command.option("pipeline", options->pipeline, "Pipeline file or name of a shipped one")
      .type_name("PIPELINE")
      .required();
  add_set_option(command, options->assignments);
  add_plugin_options(command, options->plugins);
}

}  // namespace xgm::cli
