// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/image/rectified_pair.hpp"

namespace xgm::geo {

Rectification::~Rectification() = default;

cv::Vec3d RectifiedPair::see(const GeoPoint& point) const {
  const cv::Point2d here = geometry->from_base(base.camera.project(point));
  const cv::Point2d there = geometry->from_match(match.camera.project(point));
  return {here.x, here.y, here.x - there.x};
}

}  // namespace xgm::geo
