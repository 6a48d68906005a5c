// SPDX-License-Identifier: Apache-2.0
#include "plugins/pipeline/surface/reasons.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "xgm/base/parallel.hpp"

namespace xgm::geo {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

CellReason reason_of(Status status) {
  switch (status) {
    case Status::masked:
      return CellReason::not_seen;
    case Status::ambiguous:
      return CellReason::ambiguous;
    case Status::occluded:
      return CellReason::occluded;
    case Status::mismatched:
      return CellReason::mismatched;
    case Status::peak:
      return CellReason::peak;
    case Status::filled:
      return CellReason::filled;
    case Status::matched:  // but its lines of sight do not meet
    case Status::out_of_range:
      break;
  }
  return CellReason::no_match;
}

/// Walks along a line of cells; those on the way are given the last height before them.
class Walker {
 public:
  explicit Walker(cv::Mat1f& lowest, const cv::Mat1f& heights)
      : lowest_(lowest), heights_(heights) {}
  void walk(cv::Point from, cv::Point step, int count) {
    float last = kNone;
    for (int k = 0; k < count; ++k, from += step) {
      if (!std::isnan(heights_(from))) last = heights_(from);
      lowest_(from) = std::fmin(lowest_(from), last);
    }
  }

 private:
  cv::Mat1f& lowest_;
  const cv::Mat1f& heights_;
};

/// For each cell the lowest of the nearest heights in the four directions; where there are none,
/// the mean.
cv::Mat1f ground_around(const cv::Mat1f& heights) {
  cv::Mat1f lowest(heights.size(), kNone);
  Walker walker(lowest, heights);
  const int right = heights.cols - 1, bottom = heights.rows - 1;
  for (int y = 0; y < heights.rows; ++y) {
    walker.walk({0, y}, {1, 0}, heights.cols);
    walker.walk({right, y}, {-1, 0}, heights.cols);
  }
  for (int x = 0; x < heights.cols; ++x) {
    walker.walk({x, 0}, {0, 1}, heights.rows);
    walker.walk({x, bottom}, {0, -1}, heights.rows);
  }
  double sum = 0, count = 0;
  for (const float height : heights) {
    if (std::isnan(height)) continue;
    sum += double{height};
    ++count;
  }
  const auto mean = static_cast<float>(count > 0 ? sum / count : 0);
  for (float& height : lowest) {
    if (std::isnan(height)) height = mean;
  }
  return lowest;
}

const SeenWindow* window_at(const SeenPair& pair, cv::Point2d pixel) {
  for (const SeenWindow& seen : pair.windows) {
    const cv::Rect& window = seen.window;
    const cv::Rect2d inside(window.x - 0.5, window.y - 0.5, window.width, window.height);
    if (inside.contains(pixel)) return &seen;
  }
  return nullptr;
}

/// Points more than `clearance` m above the ground hide it.
CellReason reason_in(const SeenPair& pair, const GeoPoint& ground, double clearance) {
  const cv::Point2d pixel = pair.base.camera.project(ground);
  const SeenWindow* const seen = window_at(pair, pixel);
  if (seen == nullptr) return CellReason::not_seen;
  const cv::Point2d base = seen->geometry->from_base(pixel);
  const cv::Point2d match = seen->geometry->from_match(pair.match.camera.project(ground));
  const cv::Rect2d image(cv::Point2d(-0.5, -0.5), cv::Size2d(seen->reasons.size()));
  if (!image.contains(base) || !image.contains(match)) return CellReason::not_seen;
  const cv::Rect pixels({}, seen->reasons.size());
  const cv::Point here(cvRound(base.x), cvRound(base.y)), there(cvRound(match.x), cvRound(match.y));
  if (!pixels.contains(here) || !pixels.contains(there)) return CellReason::not_seen;
  if (seen->match_valid(there) == 0) return CellReason::not_seen;
  const auto reason = static_cast<CellReason>(seen->reasons(here));
  if (reason != CellReason::height) return reason;
  const bool is_hidden = double{seen->heights(here)} > ground.height + clearance;
  return is_hidden ? CellReason::occluded : CellReason::between_points;
}

}  // namespace

SeenWindow remember(const cv::Rect& window, const RectifiedPair& pair, const MatchRequest& matching,
                    const DisparityMap& map, const PointGrid& points) {
  const Image& base = matching.pair.base;
  SeenWindow seen{window, pair.geometry, cv::Mat1b(map.size()), cv::Mat1f(map.size(), kNone),
                  matching.pair.match.valid};
  parallel_for(0, map.size().height, [&](int y) {
    for (int x = 0; x < map.size().width; ++x) {
      CellReason reason = reason_of(map.at(y, x));
      if (matching.range.at(y, x).empty()) reason = CellReason::outside_bounds;
      if (base.valid(y, x) == 0) reason = CellReason::not_seen;
      if (!std::isnan(points.ecef(y, x)[0])) {
        reason = CellReason::height;
        seen.heights(y, x) = static_cast<float>(to_geodetic(points.ecef(y, x)).height);
      }
      seen.reasons(y, x) = static_cast<std::uint8_t>(reason);
    }
  });
  return seen;
}

cv::Mat1b explain_cells(const GridSpec& grid, const cv::Mat1f& fused,
                        const std::vector<Raster>& surfaces, const std::vector<SeenPair>& pairs) {
  const cv::Mat1f ground = ground_around(fused);
  const CrsTransform to_grid("EPSG:4326", grid.crs);
  const double clearance = 3 * grid.place.step_x;
  cv::Mat1b reasons(fused.size(), static_cast<std::uint8_t>(CellReason::height));
  parallel_for(0, fused.rows, [&](int y) {
    for (int x = 0; x < fused.cols; ++x) {
      if (!std::isnan(fused(y, x))) continue;
      const cv::Point2d centre = grid.place.centre(x, y);
      const cv::Vec3d place = to_grid.inverse({centre.x, centre.y, 0});
      CellReason reason = CellReason::not_seen;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const bool has_height = !std::isnan(surfaces[i].values(y, x));
        reason = std::max(
            reason, has_height ? CellReason::too_few_pairs
                               : reason_in(pairs[i], {place[0], place[1], double{ground(y, x)}},
                                           clearance));
      }
      reasons(y, x) = static_cast<std::uint8_t>(reason);
    }
  });
  return reasons;
}

void mark_outside(const Outline& outline, const GridSpec& grid, cv::Mat1b& reasons) {
  if (outline.empty()) return;
  Raster inside{cv::Mat1f(grid.size, 0.0F), grid.place, grid.crs, {}};
  clear_outside(outline, inside);
  for (int y = 0; y < reasons.rows; ++y) {
    for (int x = 0; x < reasons.cols; ++x) {
      if (!std::isnan(inside.values(y, x))) continue;
      reasons(y, x) = static_cast<std::uint8_t>(CellReason::not_seen);
    }
  }
}

}  // namespace xgm::geo
