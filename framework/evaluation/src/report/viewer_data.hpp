// SPDX-License-Identifier: Apache-2.0
// What the page's program reads: colours, and maps as numbers.
#pragma once

#include <vector>

#include "report/scene_view.hpp"

namespace xgm::report {

/// Maps have `pixels` pixels at most.
Json viewer_data(const std::vector<SceneView>& views, double pixels);

/// JSON as it may stand inside of a script element, whatever text it has.
std::string script_text(const Json& json);

}  // namespace xgm::report
