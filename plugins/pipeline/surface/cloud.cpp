// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/surface/cloud.hpp"

#include <algorithm>
#include <cmath>

#include "xgm/base/parallel.hpp"

namespace xgm::geo {

void append(PointCloud& cloud, const PointGrid& points, const DisparityMap& map,
            const cv::Mat1f& grey, const Rectification& geometry, const cv::Rect& window) {
  const cv::Rect2d inside(window.x - 0.5, window.y - 0.5, window.width, window.height);
  for (int y = 0; y < points.ecef.rows; ++y) {
    for (int x = 0; x < points.ecef.cols; ++x) {
      if (std::isnan(points.ecef(y, x)[0])) continue;
      if (!inside.contains(geometry.to_base(cv::Point2d(x, y)))) continue;
      const GeoPoint point = to_geodetic(points.ecef(y, x));
      cloud.add({point.longitude, point.latitude, point.height}, grey(y, x), points.gap(y, x),
                map.at(y, x) == Status::filled);
    }
  }
}

void move_to_grid(PointCloud& cloud, const CrsTransform& to_grid) {
  std::vector<cv::Vec3d>& points = cloud.points;
  constexpr std::size_t kBlock = 4096;
  parallel_for(0, static_cast<int>((points.size() + kBlock - 1) / kBlock), [&](int block) {
    const std::size_t begin = static_cast<std::size_t>(block) * kBlock;
    for (std::size_t i = begin; i < std::min(begin + kBlock, points.size()); ++i) {
      const cv::Vec3d place = to_grid.forward({points[i][0], points[i][1], 0});
      points[i] = {place[0], place[1], points[i][2]};
    }
  });
}

GridPoints with_values(GridPoints points, const std::vector<float>& values) {
  for (std::size_t i = 0; i < points.size(); ++i) points[i][2] = double{values[i]};
  return points;
}

}  // namespace xgm::geo
