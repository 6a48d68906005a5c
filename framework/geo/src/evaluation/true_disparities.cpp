// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/evaluation/true_disparities.hpp"

#include <algorithm>
#include <cmath>

#include "ground/height_grid.hpp"
#include "xgm/base/error.hpp"
#include "xgm/base/parallel.hpp"
#include "xgm/geo/ground/dem.hpp"

namespace xgm::geo {
namespace {

constexpr int kStep = 2;       // px between pixels that are judged
constexpr double kLift = 0.3;  // m above a point from which its occluder is looked for

/// A raster's CRS with heights above the ellipsoid.
Crs crs_of(const Raster& surface) {
  const Crs crs = crs_with_heights(surface.crs, surface.metadata);
  if (!crs.empty() && has_ellipsoidal_heights(crs)) return crs;
  throw Error(
      "the true surface does not say that its heights are above the ellipsoid; so true "
      "disparities are not known");
}

}  // namespace

struct TrueDisparities::Impl {
  explicit Impl(const Raster& surface)
      : values(surface.values),
        place(surface.place),
        grid(filled(surface.values), surface.place),
        bounds(bounds_of(surface.values)),
        to_map(std::string(kWgs84), crs_of(surface)) {}

  static HeightInterval bounds_of(const cv::Mat1f& heights) {
    HeightInterval bounds{INFINITY, -INFINITY};
    for (const float height : heights) {
      if (!std::isfinite(height)) continue;
      bounds = {std::min(bounds.min, double{height}), std::max(bounds.max, double{height})};
    }
    if (bounds.min > bounds.max) throw Error("the true surface has no heights");
    return {bounds.min - 1, bounds.max + 1};
  }
  /// Holes lie below all; what is hit in one counts for nothing.
  static cv::Mat1f filled(const cv::Mat1f& heights) {
    cv::Mat1f copy = heights.clone();
    const auto below = static_cast<float>(bounds_of(heights).min);
    for (float& height : copy) {
      if (!std::isfinite(height)) height = below;
    }
    return copy;
  }

  cv::Vec3d map(const GeoPoint& p) const {
    return to_map.forward({p.longitude, p.latitude, p.height});
  }

  bool known(const cv::Vec3d& p) const {
    const cv::Point2d cell = place.cell({p[0], p[1]});
    const int i = cvFloor(cell.x), j = cvFloor(cell.y);
    const cv::Rect inside(0, 0, values.cols - 1, values.rows - 1);
    if (!inside.contains(cv::Point(i, j))) return false;
    return std::isfinite(values(j, i) + values(j, i + 1) + values(j + 1, i) + values(j + 1, i + 1));
  }

  /// Where a sight first meets the surface, on the map.
  std::optional<cv::Vec3d> meet(const RpcCamera& camera, cv::Point2d pixel) const {
    const auto high = camera.localize(pixel, bounds.max), low = camera.localize(pixel, bounds.min);
    if (!high || !low) return std::nullopt;
    const cv::Vec3d from = map(*high), to = map(*low);
    const auto share = grid.first_hit(from, to);
    if (!share) return std::nullopt;
    return from + *share * (to - from);
  }

  bool is_seen(const RpcCamera& camera, cv::Point2d pixel, const cv::Vec3d& point) const {
    const auto high = camera.localize(pixel, bounds.max);
    if (!high) return false;
    const cv::Vec3d from = map(*high);
    if (from[2] - point[2] <= kLift) return true;
    return !grid.first_hit(from, point + kLift / (from[2] - point[2]) * (from - point));
  }

  cv::Mat1f values;
  GridPlace place;
  HeightGrid grid;
  HeightInterval bounds;
  CrsTransform to_map;
};

TrueDisparities::TrueDisparities(const Raster& surface) : impl_(std::make_unique<Impl>(surface)) {}
TrueDisparities::~TrueDisparities() = default;

std::optional<TrueDisparities::Sight> TrueDisparities::at(const RectifiedPair& pair,
                                                          cv::Point2d rectified) const {
  const auto shows = [](const SatelliteImage& image, cv::Point2d pixel) {
    return pixel.x >= -0.5 && pixel.y >= -0.5 && pixel.x <= image.size.width - 0.5 &&
           pixel.y <= image.size.height - 0.5;
  };
  const cv::Point2d pixel = pair.geometry->to_base(rectified);
  if (!shows(pair.base, pixel)) return std::nullopt;
  const auto point = impl_->meet(pair.base.camera, pixel);
  if (!point || !impl_->known(*point)) return std::nullopt;
  const cv::Vec3d place = impl_->to_map.inverse(*point);
  const GeoPoint ground{place[0], place[1], place[2]};
  const cv::Point2d other = pair.match.camera.project(ground);
  return Sight{
      .disparity = pair.see(ground)[2],
      .visible = shows(pair.match, other) && impl_->is_seen(pair.match.camera, other, *point)};
}

void DisparityJudge::add(const RectifiedPair& pair, const DisparityMap& map) {
  const cv::Size few((map.size().width + kStep - 1) / kStep,
                     (map.size().height + kStep - 1) / kStep);
  cv::Mat1f truth(few, NAN);
  cv::Mat1b visible(few, std::uint8_t{0});
  parallel_for(0, few.height, [&](int row) {
    for (int column = 0; column < few.width; ++column) {
      const auto sight = truth_.at(pair, cv::Point2d(column * kStep, row * kStep));
      if (!sight) continue;
      truth(row, column) = static_cast<float>(sight->disparity);
      visible(row, column) = sight->visible ? 255 : 0;
    }
  });
  for (int row = 0; row < few.height; ++row) {
    for (int column = 0; column < few.width; ++column) {
      if (!std::isfinite(truth(row, column))) continue;
      true_.push_back(truth(row, column));
      visible_.push_back(visible(row, column));
      found_.push_back(map.disparity(row * kStep, column * kStep));
    }
  }
}

std::vector<RegionEvaluation> DisparityJudge::evaluate() const {
  if (true_.empty()) return {};
  const int count = static_cast<int>(true_.size());
  DisparityMap map(cv::Size(count, 1), Status::ambiguous);
  GroundTruth truth;
  truth.disparity.create(1, count);
  truth.non_occluded.create(1, count);
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (std::isfinite(found_[k])) map.set(0, i, found_[k]);
    truth.disparity(0, i) = true_[k];
    truth.non_occluded(0, i) = visible_[k];
  }
  const EvaluationRules rules{.deltas = usual_thresholds()};
  std::vector<RegionEvaluation> regions;
  for (const Region& region : regions_of(truth)) {
    if (region.name != "all" && region.name != "non-occluded") continue;
    regions.push_back({region.name, xgm::evaluate(map, truth.disparity, rules, region.mask)});
  }
  return regions;
}

}  // namespace xgm::geo
