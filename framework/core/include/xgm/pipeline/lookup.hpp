// SPDX-License-Identifier: Apache-2.0
// Finds what a user names: shipped pipelines, plugins, kinds. Misses are answered with suggestions.
#pragma once

#include <string>
#include <vector>

#include "xgm/base/export.hpp"
#include "xgm/pipeline/installation.hpp"
#include "xgm/pipeline/pipeline.hpp"
#include "xgm/plugin/registry.hpp"

namespace xgm {

/// Names of the pipeline files (*.yaml) in a folder, sorted; none if there is no such folder.
XGM_API std::vector<std::string> shipped_pipelines(const std::string& folder = pipelines_folder());

/// A pipeline file: `name` itself if it is a file, else the one of that name in `folder`, with or
/// without ".yaml". Throws UsageError that lists the names there are.
XGM_API std::string find_pipeline(const std::string& name,
                                  const std::string& folder = pipelines_folder());

/// Finds, loads and checks: "sgm8" is a shipped pipeline, "my/own.yaml" a file. Throws UsageError
/// with all that is wrong, a line each.
XGM_API Pipeline require_pipeline(const std::string& name, const Registry& registry,
                                  const std::vector<Override>& overrides = {});

/// All plugins called `name` ("census"), or the one of a kind ("cost/census"). Throws UsageError
/// if there is none, saying so if a plugin file of that name could not be loaded.
XGM_API std::vector<const PluginInfo*> find_plugins(const std::string& name,
                                                    const Registry& registry);

/// The files that the registry's plugins were loaded from.
XGM_API std::vector<std::string> plugin_files(const Registry& registry);

/// Throws UsageError unless `name` is one of `names`; says what there is none of: "there is no
/// option
/// '--swep'; did you mean '--sweep'?"
XGM_API void require_name(const std::string& what, const std::string& name,
                          const std::vector<std::string>& names);

/// Throws UsageError unless there is such a kind of stage.
XGM_API void require_kind(const std::string& kind, const Registry& registry);

}  // namespace xgm
