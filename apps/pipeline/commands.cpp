// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"

#include <CLI/CLI.hpp>

namespace xgm::cli {

CLI::App& add_command(CLI::App& app, Invocation& call, const std::string& name,
                      const std::string& text, std::function<int()> body) {
  CLI::App* command = app.add_subcommand(name, text);
  command->callback([&call, body = std::move(body)] { call.exit_code = body(); });
  return *command;
}

}  // namespace xgm::cli
