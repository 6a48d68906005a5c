// SPDX-License-Identifier: Apache-2.0
// Plugins and pipelines, as commands name them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command_line/command.hpp"
#include "xgm/pipeline/pipeline.hpp"

namespace xgm::cli {

struct PluginOptions {
  std::vector<std::string> files;  ///< --plugin
};
void add_plugin_options(Command command, PluginOptions& options);

/// The built-in plugins, those of --plugin, of XGM_PLUGIN_PATH and of the installation's folder of
/// plugins.
Registry load_plugins(const PluginOptions& options);
/// What satellite pipelines need, or why this program lacks it.
void add_satellites(Registry& registry);
/// All of these. Files that cannot be loaded are warned of, and do not stop anything that does not
/// need them.
Registry make_registry(const PluginOptions& options);

void add_set_option(Command command, std::vector<std::string>& assignments);
/// "path=value" as overrides. Throws UsageError.
std::vector<Override> parse_overrides(const std::vector<std::string>& assignments);

/// Whether a file is a scene of satellite images, which has the place of a scene behind a pipeline.
bool is_satellite_scene(const std::string& file);

/// Finds, loads and checks; prints all that is wrong to stderr. Empty if anything is.
std::optional<Pipeline> load_named(const std::string& name, const Registry& registry,
                                   const std::vector<Override>& overrides);

}  // namespace xgm::cli
