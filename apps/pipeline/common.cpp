// SPDX-License-Identifier: Apache-2.0
#include "common.hpp"

#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <opencv2/core/utility.hpp>

#include "console.hpp"
#include "xgm/io/file.hpp"
#include "xgm/pipeline/lookup.hpp"

namespace xgm::cli {
namespace fs = std::filesystem;

void add_plugin_options(CLI::App& command, PluginOptions& options) {
  command
      .add_option("--plugin", options.files,
                  "Load a plugin file; may be given again. XGM_PLUGIN_PATH holds further files and "
                  "folders, separated by colons")
      ->type_name("FILE")
      ->allow_extra_args(false);
}

Registry make_registry(const PluginOptions& options) {
  Registry registry = Registry::with_builtins();
  for (const std::string& file : options.files) registry.load(file);
  if (const char* paths = std::getenv("XGM_PLUGIN_PATH")) registry.load_path(paths);
  for (const LoadFailure& failure : registry.failures()) {
    spdlog::warn("plugin {} could not be loaded: {}", failure.file, failure.reason);
  }
  return registry;
}

void add_set_option(CLI::App& command, std::vector<std::string>& assignments) {
  command
      .add_option("--set", assignments,
                  "Replace or add a parameter, for example matcher.search_range.window=31; the "
                  "value is YAML; may be given again")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
}

std::vector<Override> parse_overrides(const std::vector<std::string>& assignments) {
  std::vector<Override> overrides;
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw UsageError("--set " + assignment + ": write PATH=VALUE, for example matcher.scale=4");
    }
    overrides.push_back({assignment.substr(0, equals), assignment.substr(equals + 1)});
  }
  return overrides;
}

CLI::Option* add_dataset_option(CLI::App& command, std::string& dataset) {
  return command
      .add_option("--dataset", dataset,
                  "How the folder is laid out, if that is not recognised: name of a data set, YAML "
                  "of one, or a file of such YAML")
      ->type_name("NAME|YAML|FILE");
}

void add_memory_limit_option(CLI::App& command, std::string& limit) {
  command
      .add_option("--memory-limit", limit,
                  "Refuse to begin what is going to take more memory than this ('pipeline plan' "
                  "tells how much it is)")
      ->type_name("SIZE");
}

void set_opencv_threads(int threads) {
  // OpenCV's scheduler complains of more threads than there are processors.
  if (threads > 0) cv::setNumThreads(std::min(threads, cv::getNumberOfCPUs()));
}

std::string pipelines_folder() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  const fs::path installed = (program.parent_path() / XGM_INSTALLED_PIPELINES).lexically_normal();
  return fs::is_directory(installed) ? installed.string() : XGM_SOURCE_PIPELINES;
}

std::optional<NamedPipeline> load_named(const std::string& name, const Registry& registry,
                                        const std::vector<Override>& overrides) {
  std::string file;
  try {
    file = find_pipeline(name, pipelines_folder());
  } catch (const Error& error) {
    spdlog::error(error.what());
    return std::nullopt;
  }
  LoadedPipeline loaded = load_pipeline(file, registry, overrides);
  for (const Diagnostic& diagnostic : loaded.diagnostics) {
    Console::instance().message(to_string(diagnostic));
  }
  if (!loaded.pipeline) return std::nullopt;
  return NamedPipeline{file, *loaded.pipeline};
}

}  // namespace xgm::cli
