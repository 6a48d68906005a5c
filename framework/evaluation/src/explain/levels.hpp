// SPDX-License-Identifier: Apache-2.0
// Where a pixel of the full images lies at a level that is known by its size alone.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace xgm::explain {

/// A power of two if halving `full` (rounding up) ends at `level`; else the ratio of the widths.
double scale_of(cv::Size full, cv::Size level);

/// The pixel of the level that covers `pixel`.
cv::Point at_level(cv::Point pixel, cv::Size full, cv::Size level);

/// The pixel of the other view that a disparity points at; may lie outside.
cv::Point pointed_at(cv::Point pixel, float disparity);

/// "s8"
std::string level_name(double scale);

/// Whether a stage that is given no images works for the other view: composite stages run what
/// concerns it in a scope called "reverse". The only place that reads a meaning from a path; all
/// other stages are known by the images they, or the matcher around them, were given.
bool in_reverse_scope(const std::string& stage_path);

}  // namespace xgm::explain
