// SPDX-License-Identifier: Apache-2.0
// Two images made comparable: points that correspond lie in one row.
#pragma once

#include <memory>
#include <opencv2/core.hpp>

#include "xgm/geo/image/satellite_image.hpp"

namespace xgm::geo {

/// The geometry of a rectified pair. Pixel (x, y) of the rectified base image with disparity d
/// corresponds to (x - d, y) of the rectified match image. Both have the same size. Safe to use
/// from several threads.
class XGM_API Rectification {
 public:
  virtual ~Rectification();
  virtual cv::Size size() const = 0;  ///< px, of both rectified images

  /// From pixels of the rectified image to those of the original one, and back.
  virtual cv::Point2d to_base(cv::Point2d rectified) const = 0;
  virtual cv::Point2d to_match(cv::Point2d rectified) const = 0;
  virtual cv::Point2d from_base(cv::Point2d pixel) const = 0;
  virtual cv::Point2d from_match(cv::Point2d pixel) const = 0;

  /// Root mean square of what corresponding points differ in y, px, over the heights it was made
  /// for.
  virtual double residual() const = 0;
};

/// A pair and how it is seen in its rectified images.
struct RectifiedPair {
  SatelliteImage base;
  SatelliteImage match;
  HeightInterval heights;  ///< of the ground, as far as it is known
  std::shared_ptr<const Rectification> geometry;

  /// Where a point is seen: x and y in the rectified base image, and its disparity.
  XGM_API cv::Vec3d see(const GeoPoint& point) const;
};

}  // namespace xgm::geo
