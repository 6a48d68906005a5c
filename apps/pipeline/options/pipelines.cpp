// SPDX-License-Identifier: Apache-2.0
#include "options/pipelines.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>

#include "terminal/console.hpp"
#include "xgm/base/error.hpp"
#ifdef XGM_HAS_GEO
#include "xgm/geo/registry.hpp"
#include "xgm/geo/run/surface_files.hpp"
#endif
#include "xgm/pipeline/lookup.hpp"

namespace xgm::cli {

void add_plugin_options(Command command, PluginOptions& options) {
  command
      .option("--plugin", options.files,
              "Load a plugin file; may be given again. XGM_PLUGIN_PATH holds further files and "
              "folders, separated by colons")
      .type_name("FILE")
      .one_value_each();
}

void add_satellites(Registry& registry) {
#ifdef XGM_HAS_GEO
  geo::add_geo(registry);
#else
  registry.add(LoadFailure{"satellites",
                           "surface",
                           "this program was built without GDAL and PROJ; install libgdal-dev and "
                           "libproj-dev, and build it again",
                           {"surface"},
                           true});
#endif
}

Registry load_plugins(const PluginOptions& options) {
  Registry registry = Registry::with_builtins();
  for (const std::string& file : options.files) registry.load(file);
  if (const char* paths = std::getenv("XGM_PLUGIN_PATH")) registry.load_path(paths);
  registry.load_path(plugins_folder());
  return registry;
}

Registry make_registry(const PluginOptions& options) {
  Registry registry = load_plugins(options);
  for (const LoadFailure& failure : registry.failures()) {
    log_warning("plugin " + failure.file + " could not be loaded: " + failure.reason);
  }
  add_satellites(registry);
  return registry;
}

void add_set_option(Command command, std::vector<std::string>& assignments) {
  command
      .option("--set", assignments,
              "Replace or add a parameter, for example matcher.search_range.window=31; the "
              "value is YAML; may be given again")
      .type_name("PATH=VALUE")
      .one_value_each();
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

bool is_satellite_scene([[maybe_unused]] const std::string& file) {
#ifdef XGM_HAS_GEO
  constexpr std::uintmax_t kMostBytes = 1 << 20;  // what is larger, or has no end, is none
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown)) return false;
  if (std::filesystem::file_size(file, unknown) > kMostBytes) return false;
  try {
    return !geo::read_surface_scene(file).images.empty();
  } catch (const UsageError&) {
    return false;
  }
#else
  return false;
#endif
}

std::optional<Pipeline> load_named(const std::string& name, const Registry& registry,
                                   const std::vector<Override>& overrides) {
  std::string file;
  try {
    file = find_pipeline(name);
  } catch (const UsageError& error) {
    log_error(error.what());
    return std::nullopt;
  }
  LoadedPipeline loaded = load_pipeline(file, registry, overrides);
  if (!loaded.pipeline && is_satellite_scene(file)) {
    log_error(file + ": is a scene of satellite images; name a pipeline before it: pipeline run " +
              "dsm_tmgm16 " + file);
    return std::nullopt;
  }
  for (const Diagnostic& diagnostic : loaded.diagnostics) {
    Console::instance().message(to_string(diagnostic));
  }
  return loaded.pipeline;
}

}  // namespace xgm::cli
