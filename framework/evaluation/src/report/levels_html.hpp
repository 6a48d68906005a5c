// SPDX-License-Identifier: Apache-2.0
// The levels of a pyramid as pictures.
#pragma once

#include <string>

#include "report/scene_view.hpp"

namespace xgm::report {

/// The map of every level of run i and how many disparities it searched where; "" without levels.
std::string levels_html(const SceneView& view, std::size_t i, double pixels);

}  // namespace xgm::report
