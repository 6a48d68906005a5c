// SPDX-License-Identifier: Apache-2.0
// Plugins and pipeline files explained to people and to editors, from their one declaration.
#pragma once

#include <string>

#include "xgm/base/export.hpp"
#include "xgm/plugin/registry.hpp"

namespace xgm {

/// A plugin's parameters with types, units, ranges, defaults and texts.
XGM_API std::string describe_text(const PluginInfo& plugin);
XGM_API std::string describe_json(const PluginInfo& plugin);
XGM_API std::string describe_markdown(const PluginInfo& plugin);
/// JSON Schema (draft 7) of pipeline files, for editors.
XGM_API std::string pipeline_schema(const Registry& registry);

}  // namespace xgm
