// SPDX-License-Identifier: Apache-2.0
// The subcommands.
#pragma once

#include "command_line/command_line.hpp"

namespace xgm::cli {

/// Every subcommand adds itself.
void add_run(CommandLine& line);
void add_eval(CommandLine& line);
void add_check(CommandLine& line);
void add_list(CommandLine& line);
void add_describe(CommandLine& line);
void add_graph(CommandLine& line);
void add_schema(CommandLine& line);
void add_bench(CommandLine& line);
void add_scenes(CommandLine& line);
void add_synth(CommandLine& line);
void add_explain(CommandLine& line);
void add_plan(CommandLine& line);
void add_speed(CommandLine& line);
void add_tiles(CommandLine& line);
void add_diff(CommandLine& line);
void add_tune(CommandLine& line);
void add_new_plugin(CommandLine& line);
void add_check_plugin(CommandLine& line);
void add_doctor(CommandLine& line);

}  // namespace xgm::cli
