// SPDX-License-Identifier: Apache-2.0
#include "shape.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "xgm/synthesis/arithmetic.hpp"

namespace xgm::synthesis {
namespace {

/// A coordinate along a ray: begin + step * (d - centre's d).
struct Along {
  double begin = 0;
  double step = 0;
  double at(double t) const { return begin + step * t; }
};

/// The ray in the shape's coordinates.
struct LocalRay {
  Along u, v, w;
};

LocalRay to_local(const Shape& s, const Ray& ray) {
  const double dx = ray.x + ray.slope * s.d - s.centre.x, dy = ray.y - s.centre.y;
  return {{(s.axis.x * dx + s.axis.y * dy) / s.half.x, s.axis.x * ray.slope / s.half.x},
          {(s.axis.x * dy - s.axis.y * dx) / s.half.y, -s.axis.y * ray.slope / s.half.y},
          {-(s.slope_x * dx + s.slope_y * dy) / s.depth, (1 - s.slope_x * ray.slope) / s.depth}};
}

/// Coefficients of the form's equation.
struct Quadric {
  double a, b, c, e, g;
};

Quadric quadric(const Shape& s) {
  switch (s.form) {
    case Shape::Form::plane:
      return {0, 0, 0, 1, 0};
    case Shape::Form::saddle:
      return {-s.bend_u, -s.bend_v, 0, 1, 0};
    case Shape::Form::ellipsoid:
      return {1, 1, 1, 0, 1};
    case Shape::Form::cylinder:
      return {1, 0, 1, 0, 1};
  }
  return {};
}

constexpr double kNone = -std::numeric_limits<double>::infinity();

/// Roots of A t^2 + B t + C = 0, the larger one first. Of a plane or saddle (`one`) only the root
/// that belongs to this side of the fold; kNone where there is none.
std::array<double, 2> solve(double A, double B, double C, bool one) {
  const double discriminant = B * B - 4 * A * C;
  if (!(discriminant >= 0)) return {kNone, kNone};
  // The usual formula loses all digits where A is small: a plane is the limit A = 0.
  const double q = -0.5 * (B + std::copysign(std::sqrt(discriminant), B));
  const double small = q != 0 ? C / q : 0;
  if (one) return {small, kNone};
  const double large = A != 0 ? q / A : kNone;
  return large > small ? std::array{large, small} : std::array{small, large};
}

bool in_ragged(const Shape& s, double u, double v) {
  const double x = u * s.half.x, y = v * s.half.y;
  const double leaves = value_noise(s.outline.key, x / s.outline.spacing, y / s.outline.spacing);
  const double boughs =
      value_noise(s.outline.key + 1, x / (4 * s.outline.spacing), y / (4 * s.outline.spacing));
  return u * u + v * v <= 1 && u * u + v * v + 1.2 * leaves + 0.8 * boughs <= 1.5;
}

bool on_bar(double position, double half, const Outline& outline) {
  const double along = (position + 1) * half / outline.spacing;
  return (along - std::floor(along)) * outline.spacing <= outline.thickness;
}

/// Hangs like a parabola from the upper corners of the rectangle.
bool on_wire(const Shape& s, double u, double v) {
  const double t = s.outline.thickness / 2 / s.half.y;
  return std::abs(u) <= 1 && std::abs(v - (1 - 2 * u * u) * (1 - t)) <= t;
}

}  // namespace

bool Shape::covers(double u, double v) const {
  const bool inside = std::abs(u) <= 1 && std::abs(v) <= 1;
  switch (outline.kind) {
    case Outline::Kind::everywhere:
      return true;
    case Outline::Kind::rectangle:
      return inside;
    case Outline::Kind::ellipse:
      return u * u + v * v <= 1;
    case Outline::Kind::ragged:
      return in_ragged(*this, u, v);
    case Outline::Kind::fence:
      return inside && (on_bar(u, half.x, outline) || on_bar(v, half.y, outline));
    case Outline::Kind::wire:
      return on_wire(*this, u, v);
  }
  return false;
}

std::optional<Hit> Shape::meet(const Ray& ray) const {
  const auto [u, v, w] = to_local(*this, ray);
  const auto [a, b, c, e, g] = quadric(*this);
  const double A = a * u.step * u.step + b * v.step * v.step + c * w.step * w.step;
  const double B =
      2 * (a * u.begin * u.step + b * v.begin * v.step + c * w.begin * w.step) + e * w.step;
  const double C =
      a * u.begin * u.begin + b * v.begin * v.begin + c * w.begin * w.begin + e * w.begin - g;
  for (const double t : solve(A, B, C, e != 0)) {
    if (t == kNone) break;
    if (covers(u.at(t), v.at(t))) return Hit{d + t, u.at(t), v.at(t), w.at(t)};
  }
  return std::nullopt;
}

bool Shape::misses(const Ray& ray, bool row_only) const {
  const bool bounded = outline.kind != Outline::Kind::everywhere || form == Form::ellipsoid;
  if (!bounded) return false;
  const double reach_x = std::abs(axis.x) * half.x + std::abs(axis.y) * half.y;
  const double reach_y = std::abs(axis.y) * half.x + std::abs(axis.x) * half.y;
  if (std::abs(ray.y - centre.y) > reach_y) return true;
  const double reach_d = depth + std::abs(bend_u) + std::abs(bend_v) + std::abs(slope_x) * reach_x +
                         std::abs(slope_y) * reach_y;
  return !row_only && std::abs(ray.x + ray.slope * d - centre.x) > reach_x + ray.slope * reach_d;
}

}  // namespace xgm::synthesis
