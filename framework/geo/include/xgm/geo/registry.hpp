// SPDX-License-Identifier: Apache-2.0
// What geo adds to a registry.
#pragma once

#include "xgm/plugin/registry.hpp"

namespace xgm::geo {

/// The kinds of stage of satellite pipelines, and the plugins of these kinds that are part of the
/// library.
XGM_API void add_geo(Registry& registry);

}  // namespace xgm::geo
