// SPDX-License-Identifier: Apache-2.0
// The plugins that Python programs can name: one registry for the process.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "xgm/pipeline/pipeline.hpp"
#include "xgm/plugin/registry.hpp"

namespace xgm::python {

/// The plugins of the library, of XGM_PLUGIN_PATH, and of the folder beside the library, as on the
/// command line; and what Python has added. The interpreter's lock is held.
Registry& registry();

/// Paths and values.
using Changes = std::vector<std::pair<std::string, std::string>>;
std::vector<Override> to_overrides(const Changes& changes);

}  // namespace xgm::python
