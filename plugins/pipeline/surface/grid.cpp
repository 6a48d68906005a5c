// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/surface/grid.hpp"

#include <algorithm>
#include <cmath>

#include "xgm/base/error.hpp"
#include "xgm/geo/image/footprint.hpp"
#include "xgm/geo/stage/range_prior.hpp"

namespace xgm::geo {
namespace {

struct Box {
  cv::Point2d low{INFINITY, INFINITY};
  cv::Point2d high{-INFINITY, -INFINITY};
  void add(cv::Point2d p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool empty() const { return !(low.x <= high.x); }
};

Box box_of(const std::vector<PointCloud>& clouds) {
  Box box;
  for (const PointCloud& cloud : clouds) {
    for (const cv::Vec3d& point : cloud.points) box.add({point[0], point[1]});
  }
  if (box.empty()) throw Error("no pixel of any pair has been matched: there is no surface");
  return box;
}

Box box_of(const DegreeBox& area, const Crs& crs) {
  const cv::Rect2d box = box_in(crs, area);
  return {box.tl(), box.br()};
}

/// The part of an image that shows ground of these heights.
cv::Rect part_of(const SatelliteImage& image, const DegreeBox& area,
                 const HeightInterval& heights) {
  Box box;
  for (int k = 0; k < 8; ++k) {
    box.add(image.camera.project({area[k % 2 == 0 ? 0 : 2], area[k / 2 % 2 == 0 ? 1 : 3],
                                  k < 4 ? heights.min : heights.max}));
  }
  static constexpr double kFar = 1e8;
  const auto first = [](double v) { return cvFloor(std::clamp(v, -kFar, kFar)); };
  const auto end = [](double v) { return cvCeil(std::clamp(v, -kFar, kFar)); };
  return cv::Rect(cv::Point(first(box.low.x), first(box.low.y)),
                  cv::Point(end(box.high.x), end(box.high.y))) &
         cv::Rect({}, image.size);
}

}  // namespace

cv::Rect window_of(const SurfaceRequest& request, const SatelliteImage& base) {
  const cv::Rect whole({}, base.size);
  const HeightInterval heights =
      request.dem != nullptr ? request.dem->bounds() : base.camera.heights();
  if (!request.window.empty()) {
    const SatelliteImage& first = request.images.front();
    if (base.file == first.file) return request.window & whole;
    const auto ground = footprint(first, request.window, heights);
    return ground ? part_of(base, *ground, heights) : cv::Rect();
  }
  return request.area ? part_of(base, *request.area, heights) : whole;
}

bool overlap(const SatelliteImage& base, const SatelliteImage& match) {
  constexpr int kPlaces = 9;   // per direction
  constexpr int kHeights = 9;  // between the lowest and the highest
  const HeightInterval heights = common_heights(base.camera, match.camera);
  for (int k = 0; k < kPlaces * kPlaces * kHeights; ++k) {
    const cv::Point2d pixel((base.size.width - 1.0) * (k % kPlaces) / (kPlaces - 1),
                            (base.size.height - 1.0) * (k / kPlaces % kPlaces) / (kPlaces - 1));
    const double share = k / kPlaces / kPlaces / (kHeights - 1.0);
    const auto point =
        base.camera.localize(pixel, heights.min + share * (heights.max - heights.min));
    if (!point) continue;
    const cv::Point2d seen = match.camera.project(*point);
    const bool inside = seen.x >= 0 && seen.y >= 0 && seen.x <= match.size.width - 1.0 &&
                        seen.y <= match.size.height - 1.0;
    if (inside) return true;
  }
  return false;
}

double ground_pixel(const SatelliteImage& image) {
  const cv::Point2d middle(image.size.width / 2.0, image.size.height / 2.0);
  const double height = image.camera.model().height.offset;
  const auto here = image.camera.localize(middle, height);
  const auto right = image.camera.localize(middle + cv::Point2d(1, 0), height);
  const auto below = image.camera.localize(middle + cv::Point2d(0, 1), height);
  if (!here || !right || !below) throw Error(image.file + ": its camera sees no ground");
  const double length =
      (cv::norm(to_ecef(*right) - to_ecef(*here)) + cv::norm(to_ecef(*below) - to_ecef(*here))) / 2;
  return std::max(0.05, std::round(length * 20) / 20);
}

double cells_shown(const SurfaceRequest& request, const SatelliteImage& image, double step) {
  const auto ground = request.area
                          ? request.area
                          : footprint(image, window_of(request, image), image.camera.heights());
  if (!ground) return 0;
  const Crs crs = utm_crs(((*ground)[0] + (*ground)[2]) / 2, ((*ground)[1] + (*ground)[3]) / 2);
  return box_in(crs, *ground).area() / (step * step);
}

Crs choose_crs(const std::optional<cv::Vec4d>& area, const std::vector<PointCloud>& clouds) {
  const Box box = area ? Box{{(*area)[0], (*area)[1]}, {(*area)[2], (*area)[3]}} : box_of(clouds);
  return utm_crs((box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2);
}

GridSpec choose_grid(const std::optional<cv::Vec4d>& area, const Crs& crs,
                     const std::vector<PointCloud>& clouds, double step) {
  const Box box = area ? box_of(*area, crs) : box_of(clouds);
  const double left = std::floor(box.low.x / step) * step;
  const double top = std::ceil(box.high.y / step) * step;
  // One more than the cells between the edges: points on the last edge have a cell, too.
  const double columns = 1 + std::floor((box.high.x - left) / step);
  const double rows = 1 + std::floor((top - box.low.y) / step);
  constexpr double kMostCells = 1U << 31U;  // what is more is no surface but a mistake
  if (columns * rows > kMostCells) {
    throw Error("a surface of " + std::to_string(std::llround(columns)) + " x " +
                std::to_string(std::llround(rows)) +
                " cells is too large; name an area, or larger cells (resolution)");
  }
  return {crs, {left, top, step, -step}, {static_cast<int>(columns), static_cast<int>(rows)}};
}

}  // namespace xgm::geo
