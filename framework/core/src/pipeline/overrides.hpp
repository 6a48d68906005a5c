// SPDX-License-Identifier: Apache-2.0
// Values from outside a pipeline file ("--set matcher.scale=4"), put into the configuration read.
#pragma once

#include "config/node.hpp"
#include "xgm/pipeline/pipeline.hpp"

namespace xgm {

/// Replaces or adds what stands at the override's path. A bare stage name on the way becomes
/// {type: name}. Faults (bad path, bad YAML) go to `diagnostics`, located at the override itself.
void apply_override(Node& root, const Override& change, Diagnostics& diagnostics);

}  // namespace xgm
