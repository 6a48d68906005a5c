// SPDX-License-Identifier: Apache-2.0
// Where a pixel of the full images lies at a level.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "xgm/stage/place.hpp"

namespace xgm::explain {

/// The pixel that covers `pixel` of the full images, `size` being that of the level. Where the
/// images are not `scale` times smaller (a matcher that turns them), the pixel in proportion.
cv::Point at_level(cv::Point pixel, cv::Size full, cv::Size size, double scale);

/// The pixel of the other view that a disparity points at; may lie outside.
cv::Point pointed_at(cv::Point pixel, float disparity);

/// As its pyramid calls it: "s8"; "s1" outside of pyramids.
std::string level_name(const Level& level);

}  // namespace xgm::explain
