// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "image/cloud_comments.hpp"
#include "xgm/base/error.hpp"
#include "xgm/geo/image/point_cloud.hpp"
#include "xgm/io/ply.hpp"

namespace xgm::geo {

void PointCloud::add(const cv::Vec3d& point, float grey, float gap, bool is_filled) {
  points.push_back(point);
  greys.push_back(grey);
  gaps.push_back(gap);
  fills.push_back(is_filled ? 1 : 0);
}

void write_clouds(const std::string& file, const Crs& crs, double resolution,
                  const std::vector<PointCloud>& pairs) {
  PlyHeader header{comments_of(crs, resolution, pairs),
                   {{"x", PlyType::float64},
                    {"y", PlyType::float64},
                    {"z", PlyType::float64},
                    {"red", PlyType::uint8},
                    {"green", PlyType::uint8},
                    {"blue", PlyType::uint8},
                    {"pair", PlyType::uint16},
                    {"gap", PlyType::float32},
                    {"source", PlyType::uint8}},
                   0};
  for (const PointCloud& pair : pairs) header.count += pair.points.size();
  write_ply(file, header, [&](const PutVertex& put) {
    for (std::size_t n = 0; n < pairs.size(); ++n) {
      const PointCloud& pair = pairs[n];
      for (std::size_t i = 0; i < pair.points.size(); ++i) {
        const cv::Vec3d& point = pair.points[i];
        const double grey{pair.greys[i]};
        put(std::array{point[0], point[1], point[2], grey, grey, grey, static_cast<double>(n),
                       double{pair.gaps[i]}, static_cast<double>(pair.fills[i])});
      }
    }
  });
}

}  // namespace xgm::geo
