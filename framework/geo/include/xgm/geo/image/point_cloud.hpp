// SPDX-License-Identifier: Apache-2.0
// The points of a pair of satellite images, and files of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "xgm/geo/ground/crs.hpp"

namespace xgm::geo {

/// One element of each vector per point.
struct PointCloud {
  std::string base, match;          ///< names of the images; `match` is empty if they are unknown
  std::vector<cv::Vec3d> points;    ///< x, y in a CRS, and the height above the ellipsoid, m
  std::vector<float> greys;         ///< of the base image, scaled as for matching: 0 to 255
  std::vector<float> gaps;          ///< shortest distance of both lines of sight, m; NaN: unknown
  std::vector<std::uint8_t> fills;  ///< 0: measured; 1: a filter has filled the disparity

  XGM_API void add(const cv::Vec3d& point, float grey, float gap, bool is_filled);
};

/// The clouds of several pairs in one CRS, as they are in files.
struct CloudSet {
  Crs crs;                ///< projected, in m
  double resolution = 0;  ///< of the surface that was made of them, m; 0: not known
  std::vector<PointCloud> pairs;
};

/// Binary little-endian PLY: double x, y, z (m above the WGS 84 ellipsoid); uchar red, green, blue;
/// ushort pair; float gap (m); uchar source (0 measured, 1 filled). Comments say the CRS, also in
/// the words of s2p, the vertical datum, the resolution, and what images a pair is made of.
XGM_API void write_clouds(const std::string& file, const Crs& crs, double resolution,
                          const std::vector<PointCloud>& pairs);

/// Of files of write_clouds() and of s2p, binary or text. x, y and z must be there, all else may be
/// missing. Points that are not finite are left out. Pairs of the same images are one pair; a file
/// without pairs counts as one. Throws UsageError if a file does not say its CRS, or another one
/// than the first, or heights above something else than the ellipsoid; Error if it cannot be read.
XGM_API CloudSet read_clouds(const std::vector<std::string>& files);

}  // namespace xgm::geo
