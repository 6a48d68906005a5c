// SPDX-License-Identifier: Apache-2.0
// Portable float maps: how Middlebury and ETH3D store disparities.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// Reads a PFM of one channel ("Pf"). Rows are stored bottom-up; the sign of the scale tells the
/// byte order and its magnitude is ignored, as Middlebury means it. Whatever is not finite on disk
/// (+inf is the convention for "none") becomes NaN. Throws Error for anything but a complete map.
XGM_API cv::Mat1f read_pfm(const std::string& file);

/// The planes of a PFM: one ("Pf") or three ("PF", here in the order blue, green, red).
XGM_API std::vector<cv::Mat1f> read_pfm_planes(const std::string& file);

/// Writes a little-endian PFM of one channel, NaN as +inf. Complete or not at all. Throws Error.
XGM_API void write_pfm(const std::string& file, const cv::Mat1f& map);

}  // namespace xgm
