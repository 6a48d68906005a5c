// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/surface/grid.hpp"

#include <algorithm>
#include <cmath>

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

/// Length of a pixel on the ground, m.
double ground_pixel(const SatelliteImage& image) {
  const cv::Point2d middle(image.size.width / 2.0, image.size.height / 2.0);
  const double height = image.camera.model().height.offset;
  const auto here = image.camera.localize(middle, height);
  const auto right = image.camera.localize(middle + cv::Point2d(1, 0), height);
  const auto below = image.camera.localize(middle + cv::Point2d(0, 1), height);
  if (!here || !right || !below) throw Error(image.file + ": its camera sees no ground");
  return (cv::norm(to_ecef(*right) - to_ecef(*here)) + cv::norm(to_ecef(*below) - to_ecef(*here))) /
         2;
}

}  // namespace

cv::Rect window_of(const SurfaceRequest& request, const SatelliteImage& base) {
  const cv::Rect whole({}, base.size);
  if (!request.area) return whole;
  const cv::Vec4d& area = *request.area;
  const HeightInterval heights =
      request.dem != nullptr ? request.dem->bounds() : base.camera.heights();
  Box box;
  for (int k = 0; k < 8; ++k) {
    box.add(base.camera.project({area[k % 2 == 0 ? 0 : 2], area[k / 2 % 2 == 0 ? 1 : 3],
                                 k < 4 ? heights.min : heights.max}));
  }
  const cv::Rect shown = cv::Rect(cv::Point(cvFloor(std::clamp(box.low.x, -1e9, 1e9)),
                                            cvFloor(std::clamp(box.low.y, -1e9, 1e9))),
                                  cv::Point(cvCeil(std::clamp(box.high.x, -1e9, 1e9)),
                                            cvCeil(std::clamp(box.high.y, -1e9, 1e9)))) &
                         whole;
  if (shown.empty()) throw Error(base.file + ": shows nothing of the requested area");
  return shown;
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

std::vector<cv::Rect> tiles(const cv::Rect& whole, int side) {
  const int columns = (whole.width + side - 1) / side, rows = (whole.height + side - 1) / side;
  std::vector<cv::Rect> windows;
  for (int k = 0; k < columns * rows; ++k) {
    const int i = k % columns, j = k / columns;
    const cv::Point begin(whole.x + whole.width * i / columns, whole.y + whole.height * j / rows);
    const cv::Point end(whole.x + whole.width * (i + 1) / columns,
                        whole.y + whole.height * (j + 1) / rows);
    windows.emplace_back(begin, end);
  }
  return windows;
}

GridSpec choose_grid(const SurfaceRequest& request, const std::vector<Cloud>& clouds,
                     double resolution) {
  Box box;
  if (request.area) {
    box.add({(*request.area)[0], (*request.area)[1]});
    box.add({(*request.area)[2], (*request.area)[3]});
  } else {
    for (const Cloud& cloud : clouds) {
      for (const GeoPoint& point : cloud.points) box.add({point.longitude, point.latitude});
    }
  }
  if (box.empty()) throw Error("no pixel of any pair has been matched: there is no surface");
  const double step =
      resolution > 0 ? resolution
                     : std::max(0.05, std::round(ground_pixel(request.images.front()) * 20) / 20);
  GridSpec grid;
  grid.crs = utm_crs((box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2);
  const CrsTransform to_grid("EPSG:4326", grid.crs);
  Box metres;
  for (int k = 0; k <= 8; ++k) {
    const double x = box.low.x + (box.high.x - box.low.x) * k / 8;
    const double y = box.low.y + (box.high.y - box.low.y) * k / 8;
    for (const cv::Point2d p : {cv::Point2d(x, box.low.y), cv::Point2d(x, box.high.y),
                                cv::Point2d(box.low.x, y), cv::Point2d(box.high.x, y)}) {
      const cv::Vec3d place = to_grid.forward({p.x, p.y, 0});
      metres.add({place[0], place[1]});
    }
  }
  grid.place = {std::floor(metres.low.x / step) * step, std::ceil(metres.high.y / step) * step,
                step, -step};
  grid.size = {static_cast<int>(std::ceil((metres.high.x - grid.place.left) / step)),
               static_cast<int>(std::ceil((grid.place.top - metres.low.y) / step))};
  return grid;
}

}  // namespace xgm::geo
