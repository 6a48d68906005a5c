// SPDX-License-Identifier: Apache-2.0
// The kinds of stage that the core knows, in the order data flows.
#pragma once

#include "xgm/plugin/registry.hpp"

namespace xgm {

void add_core_kinds(Registry& registry);

}  // namespace xgm
