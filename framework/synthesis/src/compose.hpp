// SPDX-License-Identifier: Apache-2.0
// What stands in a scene.
#pragma once

#include "surface.hpp"
#include "xgm/synthesis/generate.hpp"

namespace xgm::synthesis {

/// The surfaces of options.content. All that either view can see lies in options.disparities.
Surfaces compose(const Options& options);

Surfaces compose_plain(const Options& options);
Surfaces compose_rich(const Options& options);

}  // namespace xgm::synthesis
