// SPDX-License-Identifier: Apache-2.0
// Pipelines that are parts of others, by the names of their files.
#pragma once

#include "config/node.hpp"
#include "xgm/plugin/registry.hpp"

namespace xgm {

/// Where the top of a file wants a pipeline (a field of kind "pipeline") and has the name of a file
/// or of a shipped one, puts what that file holds. A file is looked for beside the one that names
/// it first. `root` is the top of a pipeline file.
void read_named_parts(Node& root, const Registry& registry, Diagnostics& diagnostics);

/// The text of a pipeline file. What is wrong goes to `diagnostics`; nothing is returned then.
std::optional<std::string> read_pipeline_text(const std::string& file, Diagnostics& diagnostics);

}  // namespace xgm
