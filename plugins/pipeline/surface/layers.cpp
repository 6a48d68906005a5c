// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/surface/layers.hpp"

#include <algorithm>
#include <cmath>

#include "xgm/base/parallel.hpp"
#include "xgm/geo/stage/reduce_cells.hpp"

namespace xgm::geo {
namespace {

/// The points of all pairs, with values of theirs for heights.
template <class Value>
GridPoints all_points(const std::vector<PointCloud>& clouds, const Value& value) {
  std::size_t count = 0;
  for (const PointCloud& cloud : clouds) count += cloud.points.size();
  GridPoints points;
  points.reserve(count);
  for (const PointCloud& cloud : clouds) {
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      points.emplace_back(cloud.points[i][0], cloud.points[i][1], value(cloud, i));
    }
  }
  return points;
}

}  // namespace

void add_layers(SurfaceResult& result) {
  result.gaps =
      reduce_cells(all_points(result.clouds, [](const PointCloud& cloud,
                                                std::size_t i) { return double{cloud.gaps[i]}; }),
                   result.grid, median)
          .values;
  const cv::Mat1f least_filled =
      reduce_cells(all_points(result.clouds,
                              [](const PointCloud& cloud, std::size_t i) {
                                return static_cast<double>(cloud.fills[i]);
                              }),
                   result.grid, [](std::span<double> fills) { return std::ranges::min(fills); })
          .values;
  const cv::Mat1f& heights = result.fused.heights.values;
  result.sources = cv::Mat1b(heights.size(), static_cast<std::uint8_t>(HeightSource::none));
  parallel_for(0, heights.rows, [&](int y) {
    for (int x = 0; x < heights.cols; ++x) {
      if (std::isnan(heights(y, x))) continue;
      const bool all_filled = least_filled(y, x) > 0;  // NaN, no point in the cell, is not
      result.sources(y, x) =
          static_cast<std::uint8_t>(all_filled ? HeightSource::filled : HeightSource::measured);
    }
  });
}

}  // namespace xgm::geo
