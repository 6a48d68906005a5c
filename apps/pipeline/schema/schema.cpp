// SPDX-License-Identifier: Apache-2.0
// pipeline schema: JSON Schema of pipeline files, for editors.
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "options/pipelines.hpp"
#include "xgm/pipeline/describe.hpp"

namespace xgm::cli {

void add_schema(CommandLine& line) {
  auto plugins = std::make_shared<PluginOptions>();
  Command command = line.add(
      "schema", "Print the JSON Schema of pipeline files, by which editors complete and check",
      [plugins] {
        std::string text = pipeline_schema(make_registry(*plugins));
        while (text.ends_with('\n')) text.pop_back();
        std::cout << text << '\n';
        return kOk;
      });
  add_plugin_options(command, *plugins);
}

}  // namespace xgm::cli
