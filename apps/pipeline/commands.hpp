// SPDX-License-Identifier: Apache-2.0
// The subcommands, and what each tells the program.
#pragma once

#include <functional>
#include <string>
#include <vector>

// CLI11 takes seconds to compile: only what adds options includes it.
namespace CLI {
class App;
}

namespace xgm::cli {

inline constexpr int kOk = 0;
inline constexpr int kFailed = 1;  ///< the run failed, or its map is empty
inline constexpr int kUsage = 2;   ///< usage or configuration; no image has been opened

/// How the program was called, and what it will return.
struct Invocation {
  std::vector<std::string> arguments;
  int exit_code = kOk;
};

/// Adds a subcommand; `body` does its work and returns the exit code.
CLI::App& add_command(CLI::App& app, Invocation& call, const std::string& name,
                      const std::string& text, std::function<int()> body);

/// Every subcommand adds itself, and leaves its exit code in `call`.
void add_run(CLI::App& app, Invocation& call);
void add_eval(CLI::App& app, Invocation& call);
void add_check(CLI::App& app, Invocation& call);
void add_list(CLI::App& app, Invocation& call);
void add_describe(CLI::App& app, Invocation& call);
void add_graph(CLI::App& app, Invocation& call);
void add_schema(CLI::App& app, Invocation& call);
void add_bench(CLI::App& app, Invocation& call);
void add_scenes(CLI::App& app, Invocation& call);
void add_synth(CLI::App& app, Invocation& call);
void add_explain(CLI::App& app, Invocation& call);
void add_plan(CLI::App& app, Invocation& call);
void add_speed(CLI::App& app, Invocation& call);

}  // namespace xgm::cli
