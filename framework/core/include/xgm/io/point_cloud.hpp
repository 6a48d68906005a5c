// SPDX-License-Identifier: Apache-2.0
// Depths and points from disparities, if the cameras are known.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <string>

#include "xgm/base/export.hpp"
#include "xgm/data/calibration.hpp"
#include "xgm/data/image.hpp"

namespace xgm {

/// The point of pixel (x, y) of the left image with this disparity (px), in the unit of the
/// baseline (mm), from the left camera: x to the right, y down, z forward. Not finite if disparity
/// + doffs is not above 0: no point in front of the cameras has such a disparity.
XGM_API cv::Point3d point_of(const Calibration& cameras, double x, double y, double disparity);

/// Z of every pixel, in the unit of the baseline; NaN where there is no disparity or no such point.
XGM_API cv::Mat1f depths(const cv::Mat1f& disparity, const Calibration& cameras);

/// Writes depths as a TIFF of 32-bit floats, NaN included. The file is complete or absent. Throws
/// Error.
XGM_API void write_depths(const std::string& file, const cv::Mat1f& depths);

/// Writes a point for every pixel that has a depth, row by row, as binary little-endian PLY: float
/// x, y, z and uchar red, green, blue of the left image. Returns the number of points. The file is
/// complete or absent. Throws Error, also if image and map differ in size.
XGM_API std::size_t write_point_cloud(const std::string& file, const cv::Mat1f& disparity,
                                      const Calibration& cameras, const Image& left);

}  // namespace xgm
