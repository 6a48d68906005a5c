// SPDX-License-Identifier: Apache-2.0
// What all subcommands share: exit codes, plugins, loading of pipelines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "xgm/base/error.hpp"
#include "xgm/pipeline/pipeline.hpp"

// CLI11 takes seconds to compile: only what adds options includes it.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace xgm::cli {

inline constexpr int kOk = 0;
inline constexpr int kFailed = 1;  ///< the run failed, or its map is empty
inline constexpr int kUsage = 2;   ///< usage or configuration; no image has been opened

/// A mistake on the command line: exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// How the program was called, and what it will return.
struct Invocation {
  std::vector<std::string> arguments;
  int exit_code = kOk;
};

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

struct PluginOptions {
  std::vector<std::string> files;  ///< --plugin
};
void add_plugin_options(CLI::App& command, PluginOptions& options);

/// The built-in plugins, those of --plugin and those of XGM_PLUGIN_PATH. Files that cannot be
/// loaded are warned of, and do not stop anything that does not need them.
Registry make_registry(const PluginOptions& options);

void add_set_option(CLI::App& command, std::vector<std::string>& assignments);
/// "path=value" as overrides. Throws UsageError.
std::vector<Override> parse_overrides(const std::vector<std::string>& assignments);

/// --dataset, for commands that take folders of scenes.
CLI::Option* add_dataset_option(CLI::App& command, std::string& dataset);

/// --memory-limit, for commands that match.
void add_memory_limit_option(CLI::App& command, std::string& limit);

/// OpenCV has one number of threads for the whole process: that of --threads, if it is given (> 0).
void set_opencv_threads(int threads);

/// The folder of the shipped pipelines.
std::string pipelines_folder();

struct NamedPipeline {
  std::string file;
  Pipeline pipeline;
};
/// Finds, loads and checks; prints all that is wrong to stderr. Empty if anything is.
std::optional<NamedPipeline> load_named(const std::string& name, const Registry& registry,
                                        const std::vector<Override>& overrides);

}  // namespace xgm::cli
