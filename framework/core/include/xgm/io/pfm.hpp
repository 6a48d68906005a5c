// SPDX-License-Identifier: Apache-2.0
// Portable float maps (PFM), the format of disparities in Middlebury and ETH3D.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "xgm/base/export.hpp"

namespace xgm {

/// Reads a PFM of one channel ("Pf"). Rows are stored bottom-up. The sign of the scale gives the
/// byte order; its magnitude is ignored, as in Middlebury. Values that are not finite (+inf stands
/// for "no disparity") become NaN. Throws Error if the file is not a complete map.
XGM_API cv::Mat1f read_pfm(const std::string& file);

/// The planes of a PFM: one ("Pf") or three ("PF", here in the order blue, green, red).
XGM_API std::vector<cv::Mat1f> read_pfm_planes(const std::string& file);

/// Writes a little-endian PFM of one channel, NaN as +inf. The file is complete or absent. Throws
/// Error.
XGM_API void write_pfm(const std::string& file, const cv::Mat1f& map);

}  // namespace xgm
