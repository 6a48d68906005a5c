// SPDX-License-Identifier: Apache-2.0
// From disparities to depths and points, where the cameras are known.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <string>

#include "xgm/base/export.hpp"
#include "xgm/data/calibration.hpp"
#include "xgm/data/image.hpp"

namespace xgm {

/// Where pixel (x, y) of the left image with this disparity (px) lies: right, down and forward of
/// the left camera, in the baseline's unit (mm). Not finite if disparity + doffs is not above 0:
/// no point before the cameras is seen so.
XGM_API cv::Point3d point_of(const Calibration& cameras, double x, double y, double disparity);

/// Z of every pixel, in the baseline's unit; NaN where there is no disparity, or no such point.
XGM_API cv::Mat1f depths(const cv::Mat1f& disparity, const Calibration& cameras);

/// Writes depths as a TIFF of 32-bit floats, NaN kept. Complete or not at all. Throws Error.
XGM_API void write_depths(const std::string& file, const cv::Mat1f& depths);

/// Writes a point for every pixel that has a depth, row by row, as binary little-endian PLY: float
/// x, y, z and uchar red, green, blue of the left image. Returns how many. Complete or not at all.
/// Throws Error, also if image and map differ in size.
XGM_API std::size_t write_point_cloud(const std::string& file, const cv::Mat1f& disparity,
                                      const Calibration& cameras, const Image& left);

}  // namespace xgm
