// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/ground/area.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "xgm/base/parallel.hpp"

namespace xgm::geo {
namespace {

/// Bounds of what the edges of a box become.
template <class Transform>
DegreeBox moved(const DegreeBox& box, const Transform& transform) {
  constexpr int kSteps = 8;  // per edge
  DegreeBox result(INFINITY, INFINITY, -INFINITY, -INFINITY);
  for (int k = 0; k <= kSteps; ++k) {
    const double x = box[0] + (box[2] - box[0]) * k / kSteps;
    const double y = box[1] + (box[3] - box[1]) * k / kSteps;
    for (const cv::Vec3d& edge : {cv::Vec3d(x, box[1], 0), cv::Vec3d(x, box[3], 0),
                                  cv::Vec3d(box[0], y, 0), cv::Vec3d(box[2], y, 0)}) {
      const cv::Vec3d p = transform(edge);
      result = {std::min(result[0], p[0]), std::min(result[1], p[1]), std::max(result[2], p[0]),
                std::max(result[3], p[1])};
    }
  }
  return result;
}

/// Where a row of cells crosses the rings, from west to east.
std::vector<double> crossings(const Outline& rings, double y) {
  std::vector<double> found;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const cv::Point2d a = ring[i], b = ring[(i + 1) % ring.size()];
      // The lower end belongs to an edge, the upper one does not: a row crosses each corner once.
      if ((a.y <= y) == (b.y <= y)) continue;
      found.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

bool intersect(const DegreeBox& a, const DegreeBox& b) {
  return a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
}

DegreeBox swapped(const DegreeBox& box) { return {box[1], box[0], box[3], box[2]}; }

std::string to_string(const DegreeBox& box) {
  char text[160];
  std::snprintf(text, sizeof text, "longitudes %.6g to %.6g, latitudes %.6g to %.6g", box[0],
                box[2], box[1], box[3]);
  return text;
}

cv::Rect2d box_in(const Crs& crs, const DegreeBox& box) {
  const CrsTransform transform("EPSG:4326", horizontal(crs));
  const DegreeBox there = moved(box, [&](const cv::Vec3d& p) { return transform.forward(p); });
  return {cv::Point2d(there[0], there[1]), cv::Point2d(there[2], there[3])};
}

DegreeBox degrees_of(const Crs& crs, const cv::Rect2d& box) {
  const CrsTransform transform("EPSG:4326", horizontal(crs));
  return moved({box.x, box.y, box.br().x, box.br().y},
               [&](const cv::Vec3d& p) { return transform.inverse(p); });
}

DegreeBox bounds_of(const Outline& outline) {
  DegreeBox box(INFINITY, INFINITY, -INFINITY, -INFINITY);
  for (const auto& ring : outline) {
    for (const cv::Point2d& p : ring) {
      box = {std::min(box[0], p.x), std::min(box[1], p.y), std::max(box[2], p.x),
             std::max(box[3], p.y)};
    }
  }
  return box;
}

void clear_outside(const Outline& outline, Raster& raster) {
  if (outline.empty()) return;
  const CrsTransform to_grid("EPSG:4326", horizontal(raster.crs));
  Outline rings = outline;
  for (auto& ring : rings) {
    for (cv::Point2d& p : ring) {
      const cv::Vec3d place = to_grid.forward({p.x, p.y, 0});
      p = {place[0], place[1]};
    }
  }
  parallel_for(0, raster.values.rows, [&](int row) {
    const std::vector<double> borders = crossings(rings, raster.place.centre(0, row).y);
    std::size_t passed = 0;
    for (int column = 0; column < raster.values.cols; ++column) {
      const double x = raster.place.centre(column, row).x;
      while (passed < borders.size() && borders[passed] <= x) ++passed;
      if (passed % 2 == 0) raster.values(row, column) = std::numeric_limits<float>::quiet_NaN();
    }
  });
}

}  // namespace xgm::geo
