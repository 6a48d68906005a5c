// SPDX-License-Identifier: Apache-2.0
// A disparity map as files, for programs and for people.
#pragma once

#include <array>
#include <string>

#include "xgm/base/export.hpp"
#include "xgm/data/disparity_map.hpp"

namespace xgm {

/// What write_maps() writes of every map.
inline constexpr std::array<const char*, 3> kMapFiles{"disparity.pfm", "disparity.png",
                                                      "status.png"};
/// What it writes of a map that has a confidence.
inline constexpr const char* kConfidenceFile = "confidence.pfm";

/// Writes disparity.pfm (px, +inf where there is none), disparity.png and status.png (pictures with
/// legends) to the folder, which is made if it is missing, and confidence.pfm (0 to 1, +inf where
/// there is none) if the map has a confidence; if not, one of another map is removed. Each file is
/// complete or not there. disparity.pfm comes first. Throws UsageError if the folder cannot be
/// made, Error if a file cannot be written.
XGM_API void write_maps(const std::string& folder, const DisparityMap& map);

/// Bytes that a picture of a map of so many pixels takes until it is written, and those that
/// write_maps() takes, which draws two at once.
XGM_API double bytes_to_draw(cv::Size size);
XGM_API double bytes_to_write_maps(cv::Size size);

}  // namespace xgm
