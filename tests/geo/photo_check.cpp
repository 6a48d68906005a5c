// SPDX-License-Identifier: Apache-2.0
#include "geo/photo_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "xgm/geo/ground/crs.hpp"

namespace xgm::testing {
namespace {

using namespace xgm::geo;

constexpr int kRadius = 6;              // cells of a patch around its middle
constexpr int kStep = 15;               // cells between patches
constexpr std::size_t kMinCells = 100;  // of a patch that have a height
constexpr double kReach = 2;            // px that the best place is looked for
constexpr double kFine = 0.25;          // px between places

double bilinear(const cv::Mat1f& image, cv::Point2d p) {
  const int x = cvFloor(p.x), y = cvFloor(p.y);
  if (x < 0 || y < 0 || x + 1 >= image.cols || y + 1 >= image.rows) return NAN;
  const double u = p.x - x, v = p.y - y;
  return (1 - v) * ((1 - u) * double{image(y, x)} + u * double{image(y, x + 1)}) +
         v * ((1 - u) * double{image(y + 1, x)} + u * double{image(y + 1, x + 1)});
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sa = 0, sb = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sa += a[i];
    sb += b[i];
    aa += a[i] * a[i];
    bb += b[i] * b[i];
    ab += a[i] * b[i];
  }
  const double n = static_cast<double>(a.size());
  return (ab - sa * sb / n) / std::sqrt((aa - sa * sa / n) * (bb - sb * sb / n));
}

/// The place along a line of offsets at which the patch correlates best; empty if at an end.
std::optional<double> best_offset(const cv::Mat1f& second, const std::vector<double>& seen,
                                  const std::vector<cv::Point2d>& places, cv::Point2d direction) {
  std::vector<double> scores;
  for (double offset = -kReach; offset <= kReach; offset += kFine) {
    std::vector<double> there;
    for (const cv::Point2d& place : places)
      there.push_back(bilinear(second, place + offset * direction));
    scores.push_back(correlation(seen, there));
    if (std::isnan(scores.back())) return std::nullopt;
  }
  const auto best = std::ranges::max_element(scores);
  const auto i = best - scores.begin();
  if (*best < 0.7 || i == 0 || best + 1 == scores.end()) return std::nullopt;
  const double bend = best[-1] - 2 * best[0] + best[1];
  return -kReach + kFine * (static_cast<double>(i) + (best[-1] - best[1]) / (2 * bend));
}

double median(std::vector<double> values) {
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

PhotoCheck photo_check(const Raster& surface, const SatelliteImage& first,
                       const SatelliteImage& second) {
  const cv::Mat1f one = read_window(first, {{}, first.size});
  const cv::Mat1f two = read_window(second, {{}, second.size});
  const CrsTransform to_wgs84(horizontal(surface.crs), "EPSG:4326");
  std::vector<double> along, across;
  for (int y = kRadius; y + kRadius < surface.values.rows; y += kStep) {
    for (int x = kRadius; x + kRadius < surface.values.cols; x += kStep) {
      std::vector<double> seen;
      std::vector<cv::Point2d> places;
      cv::Point2d line;
      for (int j = -kRadius; j <= kRadius; ++j) {
        for (int i = -kRadius; i <= kRadius; ++i) {
          if (std::isnan(surface.values(y + j, x + i))) continue;
          const cv::Point2d centre = surface.place.centre(x + i, y + j);
          const cv::Vec3d place = to_wgs84.forward({centre.x, centre.y, 0});
          const GeoPoint point{place[0], place[1], double{surface.values(y + j, x + i)}};
          seen.push_back(bilinear(one, first.camera.project(point)));
          places.push_back(second.camera.project(point));
          if (i == 0 && j == 0) {
            // The epipolar line: where the point would be seen if it rose along the first sight.
            const auto higher =
                first.camera.localize(first.camera.project(point), point.height + 10);
            if (higher) line = second.camera.project(*higher) - places.back();
          }
        }
      }
      const double length = cv::norm(line);
      if (!(length > 0) || seen.size() < kMinCells ||
          std::ranges::any_of(seen, [](double g) { return std::isnan(g); }))
        continue;
      const cv::Point2d direction = line / length;
      if (const auto offset = best_offset(two, seen, places, direction)) along.push_back(*offset);
      if (const auto offset = best_offset(two, seen, places, {-direction.y, direction.x})) {
        across.push_back(*offset);
      }
    }
  }
  return {median(along), median(across), static_cast<int>(along.size())};
}

}  // namespace xgm::testing
