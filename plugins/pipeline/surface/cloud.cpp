// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/surface/cloud.hpp"

#include <algorithm>
#include <cmath>

#include "xgm/base/parallel.hpp"

namespace xgm::geo {

void append(Cloud& cloud, const PointGrid& points, const cv::Mat1f& grey,
            const Rectification& geometry, const cv::Rect& window) {
  const cv::Rect2d inside(window.x - 0.5, window.y - 0.5, window.width, window.height);
  for (int y = 0; y < points.ecef.rows; ++y) {
    for (int x = 0; x < points.ecef.cols; ++x) {
      if (std::isnan(points.ecef(y, x)[0])) continue;
      if (!inside.contains(geometry.to_base(cv::Point2d(x, y)))) continue;
      cloud.points.push_back(to_geodetic(points.ecef(y, x)));
      cloud.greys.push_back(grey(y, x));
    }
  }
}

GridPoints on_grid(const Cloud& cloud, const CrsTransform& to_grid) {
  GridPoints points(cloud.points.size());
  constexpr std::size_t kBlock = 4096;
  parallel_for(0, static_cast<int>((points.size() + kBlock - 1) / kBlock), [&](int block) {
    const std::size_t begin = static_cast<std::size_t>(block) * kBlock;
    for (std::size_t i = begin; i < std::min(begin + kBlock, points.size()); ++i) {
      const GeoPoint& point = cloud.points[i];
      const cv::Vec3d place = to_grid.forward({point.longitude, point.latitude, 0});
      points[i] = {place[0], place[1], point.height};
    }
  });
  return points;
}

GridPoints with_greys(GridPoints points, const Cloud& cloud) {
  for (std::size_t i = 0; i < points.size(); ++i) points[i][2] = double{cloud.greys[i]};
  return points;
}

}  // namespace xgm::geo
