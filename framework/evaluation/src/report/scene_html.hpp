// SPDX-License-Identifier: Apache-2.0
// The static part of the page: one section per scene.
#pragma once

#include <string>

#include "report/scene_view.hpp"

namespace xgm::report {

/// `alone`: it is the only scene, and the page has its name already.
/// `pixels`: most pixels of maps in the viewer, which the left image is shared with; the other
/// pictures have fewer.
std::string scene_html(const SceneView& view, std::size_t index, bool alone, double pixels);

}  // namespace xgm::report
