// SPDX-License-Identifier: Apache-2.0
#include "xgm/geo/camera/rpc_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "camera/rpc_polynomials.hpp"
#include "xgm/base/parallel.hpp"

namespace xgm::geo {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kPrecision = 1e-8;  // px
constexpr int kMaxRounds = 30;
// How far beyond their scales models may be used: crops and borders of vendors' models reach a
// little further, and polynomials of third order run away soon after.
constexpr double kSlack = 0.5;
// Points of a batch that are worth a task of their own.
constexpr int kBlock = 4096;

template <class Body>
void for_blocks(std::size_t count, const Body& body) {
  const int blocks = static_cast<int>((count + kBlock - 1) / kBlock);
  parallel_for(0, blocks, [&](int block) {
    const std::size_t begin = static_cast<std::size_t>(block) * kBlock;
    body(begin, std::min(begin + kBlock, count));
  });
}

}  // namespace

HeightInterval RpcCamera::heights() const {
  return {model_.height.value(-1), model_.height.value(1)};
}

HeightInterval RpcCamera::reach() const {
  return {model_.height.value(-1 - kSlack), model_.height.value(1 + kSlack)};
}

bool RpcCamera::covers(const GeoPoint& point, double slack) const {
  const auto within = [&](const RpcAxis& axis, double value) {
    return std::abs(axis.normalised(value)) <= 1 + slack;  // false for NaN
  };
  return within(model_.longitude, point.longitude) && within(model_.latitude, point.latitude) &&
         within(model_.height, point.height);
}

cv::Point2d RpcCamera::project(const GeoPoint& point) const {
  const RpcTerms terms =
      rpc_terms(model_.longitude.normalised(point.longitude),
                model_.latitude.normalised(point.latitude), model_.height.normalised(point.height));
  return {model_.column.value(value(model_.column_ratio, terms)),
          model_.row.value(value(model_.row_ratio, terms))};
}

std::optional<GeoPoint> RpcCamera::localize(cv::Point2d pixel, double height) const {
  const double column = model_.column.normalised(pixel.x), row = model_.row.normalised(pixel.y);
  const double h = model_.height.normalised(height);
  double l = 0, p = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    const RpcTerms terms = rpc_terms(l, p, h);
    const double c = value(model_.column_ratio, terms), r = value(model_.row_ratio, terms);
    const double column_error = column - c, row_error = row - r;
    const GeoPoint point{model_.longitude.value(l), model_.latitude.value(p), height};
    if (std::abs(column_error * model_.column.scale) < kPrecision &&
        std::abs(row_error * model_.row.scale) < kPrecision) {
      return covers(point, kSlack) ? std::optional(point) : std::nullopt;
    }
    const RpcTerms by_l = rpc_terms_by_longitude(l, p, h), by_p = rpc_terms_by_latitude(l, p, h);
    const double c_l = derivative(model_.column_ratio, terms, by_l, c);
    const double c_p = derivative(model_.column_ratio, terms, by_p, c);
    const double r_l = derivative(model_.row_ratio, terms, by_l, r);
    const double r_p = derivative(model_.row_ratio, terms, by_p, r);
    const double determinant = c_l * r_p - c_p * r_l;
    l += (r_p * column_error - c_p * row_error) / determinant;
    p += (c_l * row_error - r_l * column_error) / determinant;
    if (!std::isfinite(l) || !std::isfinite(p)) return std::nullopt;
  }
  return std::nullopt;
}

void RpcCamera::project(std::span<const GeoPoint> points, std::span<cv::Point2d> pixels) const {
  for_blocks(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) pixels[i] = project(points[i]);
  });
}

std::size_t RpcCamera::localize(std::span<const cv::Point2d> pixels,
                                std::span<const double> heights, std::span<GeoPoint> points,
                                std::span<std::uint8_t> found) const {
  for_blocks(pixels.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto point = localize(pixels[i], heights[i]);
      found[i] = point.has_value();
      if (point) points[i] = *point;
    }
  });
  return static_cast<std::size_t>(std::ranges::count_if(found, [](auto f) { return f != 0; }));
}

std::optional<Ray> RpcCamera::ray(cv::Point2d pixel) const {
  const HeightInterval range = heights();
  const auto high = localize(pixel, range.max), low = localize(pixel, range.min);
  if (!high || !low) return std::nullopt;
  const cv::Vec3d origin = to_ecef(*high);
  return Ray{origin, cv::normalize(to_ecef(*low) - origin)};
}

std::optional<ViewAngles> RpcCamera::view_angles(cv::Point2d pixel) const {
  const auto ground = localize(pixel, model_.height.offset);
  const auto sight = ray(pixel);
  if (!ground || !sight) return std::nullopt;
  const cv::Vec3d up = local_axes(*ground).t() * -sight->direction;  // east, north, up
  const double azimuth = std::atan2(up[0], up[1]) / kDegree;
  return ViewAngles{azimuth < 0 ? azimuth + 360 : azimuth,
                    std::atan2(std::hypot(up[0], up[1]), up[2]) / kDegree};
}

RpcCamera RpcCamera::cropped(cv::Point2d origin) const {
  RpcModel model = model_;
  model.column.offset -= origin.x;
  model.row.offset -= origin.y;
  return RpcCamera(model);
}

RpcCamera RpcCamera::reduced(int by) const {
  RpcModel model = model_;
  for (RpcAxis* axis : {&model.column, &model.row}) {
    // Edges of pixels lie half a pixel before their centres, in both images.
    axis->offset = (axis->offset + 0.5) / by - 0.5;
    axis->scale /= by;
  }
  return RpcCamera(model);
}

double angle_between(const Ray& a, const Ray& b) {
  const double sine = cv::norm(a.direction.cross(b.direction));
  return std::atan2(sine, a.direction.dot(b.direction)) / kDegree;
}

HeightInterval common_heights(const RpcCamera& a, const RpcCamera& b) {
  return {std::max(a.heights().min, b.heights().min), std::min(a.heights().max, b.heights().max)};
}

}  // namespace xgm::geo
